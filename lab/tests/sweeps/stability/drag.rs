//! Drag alone: sixteen speeds at each `k h / m` and each `h c |v| / m`, as a force and as a factor.
//!
//! ```text
//! linear      force   v' = f(k h / m) v         one kick: f(g) = 1 - g
//!             factor  v' = exp(-k h / m) v
//! quadratic   force   v' = f(h c |v| / m) v     one kick: f(a) = 1 - a
//!             factor  v' = v / (1 + h c |v| / m), in two halves as well: 1/|v| grows by half of it twice
//! ```
//!
//! So a force is monotone where f >= 0, swings where f < 0 and explodes where |f| > 1, for one kick
//! from 1 and from 2 on; a factor never does.

use fixstep::{Force, Point, World};

use super::scene::*;
use crate::support::*;

/// The speed of all bodies, 1/1024 of the range and a power of two: a coasting body stays inside it,
/// where drag stops it within 100 steps of a second's eighth.
pub fn speed<S: Number>() -> f64 {
    reach::<S>().log2().round().exp2() / 1024.0
}

/// Sixteen bodies of one speed in all directions.
fn fan<S: Number>() -> World<Point<S>, 16> {
    let speed = speed::<S>();
    let body = |i| {
        point(
            [0.0; 2],
            [speed * angle(i).cos(), speed * angle(i).sin()],
            1.0,
        )
    };
    world(std::array::from_fn(body))
}

/// How a speed goes on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Course {
    /// It falls and keeps its sign, or comes to rest.
    Monotone,
    /// It falls and changes its sign.
    Swinging,
    /// It rises.
    Exploding,
    /// Stages of one step are at the end of the range: they may cancel, and the speed stay as it is.
    Clamped,
}

/// What a factor a step makes of it.
fn course(factor: f64) -> Course {
    match factor {
        _ if factor.abs() > 1.0 => Course::Exploding,
        _ if factor < 0.0 => Course::Swinging,
        _ => Course::Monotone,
    }
}

/// Speeds, and the parts of the velocities along the start of each body.
fn speeds<S: Number>(world: &World<Point<S>, 16>) -> [[f64; 2]; 16] {
    std::array::from_fn(|i| {
        let v = world.bodies()[i].velocity().to_f64();
        [v.x.hypot(v.y), v.x * angle(i).cos() + v.y * angle(i).sin()]
    })
}

/// A drag by its factor, of the speed before the step.
pub struct Drag<'a> {
    pub name: String,
    pub factor: &'a dyn Fn(f64) -> f64,
    /// `k h / m`, or `h c |v| / m` at the start.
    pub rate: f64,
    /// Force calls of a step; one for a factor.
    pub calls: i32,
}

impl Drag<'_> {
    /// Sixteen runs of 1000 steps, or until all have come to 16 times their speed, 1/64 of the range,
    /// to where four calls are clamped, or lost 999 parts of a thousand. Each step inside half of the
    /// range is the factor's. Later the kick of fixed point saturates and turns the velocity round: it
    /// swings inside the range for ever, and the world has nothing to tell.
    pub fn check<S: Number>(&self, scheme: Scheme, force: &mut impl Force<Point<S>>) -> Course {
        let mut world = fan::<S>();
        let (mut method, step, start) = (scheme.method(), step(), speed::<S>());
        let what = format!("{} {scheme:?} {} {}", S::name(), self.name, self.rate);
        let expected = course((self.factor)(start));
        let (mut far, mut before, mut seen) = ([false; 16], speeds(&world), vec![]);
        for tick in 0..self.patience::<S>(expected) {
            world.step(&mut method, force, &step);
            let now = speeds(&world);
            for ((far, before), now) in far.iter_mut().zip(&before).zip(&now) {
                if !*far {
                    self.check_step::<S>(&what, *before, *now);
                    *far = now[0] >= 16.0 * start || self.clamped::<S>(now[0]);
                }
            }
            if tick == 0 {
                seen = (0..16).map(|i| self.seen::<S>(before[i], now[i])).collect();
            }
            before = now;
            let gone = far.iter().all(|&far| far);
            if gone || now.iter().all(|now| now[0] <= 1e-3 * start) {
                break;
            }
        }
        if self.clamped::<S>(start) {
            return Course::Clamped;
        }
        let fate = expected == Course::Exploding;
        assert!(far.iter().all(|&far| far == fate), "{what}: far {far:?}");
        assert!(
            fate || before.iter().all(|now| now[0] <= start),
            "{what}: {before:?}"
        );
        assert!(
            seen.iter().all(|&seen| seen == expected),
            "{what}: {seen:?}"
        );
        expected
    }

    /// Steps in which an exploding speed grows 16 times, with a few to spare: the factor of the start
    /// rises with the speed if it changes at all.
    fn patience<S: Number>(&self, expected: Course) -> u32 {
        let growth = (self.factor)(speed::<S>()).abs().ln();
        match expected {
            Course::Exploding => 10 + (1.1 * 16.0_f64.ln() / growth) as u32,
            _ => 1000,
        }
    }

    /// One step by the factor. Each axis is rounded by half a unit, or loses one where half would be
    /// left; the rate is a product of coefficients, at most eight times as wrong as one of two, and,
    /// where the speed is in it, off by the rounding of that. Each call rounds, and makes terms 1 +
    /// rate times as large.
    fn check_step<S: Number>(&self, what: &str, [speed, along]: [f64; 2], now: [f64; 2]) {
        let exact = (self.factor)(speed) * along;
        let rate = self.rate * (speed / self::speed::<S>()).max(1.0);
        let unit = S::unit(speed.max(exact.abs()));
        let terms = f64::from(self.calls) * (1.0 + rate).powi(self.calls);
        let bound = 2.0 * terms * unit + 8.0 * S::COEFFICIENT * terms * speed;
        let error = (now[1] - exact).abs();
        assert!(
            !self.inside::<S>(speed) || error <= bound,
            "{what}: {now:?} for {exact}, {error:e} > {bound:e}"
        );
    }

    /// Whether no part of a step from this speed comes near the end of the range.
    fn inside<S: Number>(&self, speed: f64) -> bool {
        let rate = self.rate * (speed / self::speed::<S>()).max(1.0);
        let exact = (self.factor)(speed) * speed;
        exact.abs().max(speed) * rate.max(1.0) <= 0.5 * reach::<S>()
    }

    /// Whether stages of a step from this speed may be clamped and cancel.
    fn clamped<S: Number>(&self, speed: f64) -> bool {
        self.calls > 1 && !is_float::<S>() && !self.inside::<S>(speed)
    }

    /// What became of a speed in one step, to a unit.
    fn seen<S: Number>(&self, before: [f64; 2], now: [f64; 2]) -> Course {
        let unit = S::unit(before[0]);
        match now[0] <= before[0] + unit {
            false => Course::Exploding,
            true if now[1] < -unit => Course::Swinging,
            true => Course::Monotone,
        }
    }
}
