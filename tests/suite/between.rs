//! Where a body is drawn between two steps: a steady one on its line, in every number type and
//! under every method.
//!
//! ```text
//! drawn = x0 + α (x1 - x0)      rounded once
//! line  = x0 + v α h
//! ```
//!
//! Both references are exact: every position here is a whole number of 2^-60, and products with a
//! part and a step stay in 128 bits.

#[path = "between/fall.rs"]
mod fall;
#[path = "between/frames.rs"]
mod frames;
#[path = "between/scene.rs"]
mod scene;
use crate::support;

use fixstep::fixed::types::{I8F24, I12F20, I16F16, I20F12};
use fixstep::{
    Between, BodyId, ConstantAcceleration, Euler, Pefrl, Point, Ratio, Rk4, SemiImplicitEuler,
    Step, Vec2, Verlet, World, dec,
};
use support::*;

const RATE: i32 = 60;

fn parts() -> [Ratio; 6] {
    let quarter = |num| Ratio::new(num, 4).unwrap();
    let [quarter, half, most] = [1, 2, 3].map(quarter);
    [Ratio::ZERO, quarter, dec!(0.3), half, most, Ratio::from(1)]
}

/// `value` in units of 2^-60: a whole number for all of fixed point, and for an `f64` from 2^-7.
fn scaled(value: f64) -> i128 {
    let scaled = value * (1_i64 << 60) as f64;
    assert_eq!(scaled.fract(), 0.0, "{value} has smaller bits");
    scaled as i128
}

/// `|value - num / den|` in units of the number type at magnitude `at`; `num` is scaled.
fn off<S: Format>(value: S, num: i128, den: i128, at: f64) -> f64 {
    let off = (scaled(value.to_f64()) * den - num).abs();
    off as f64 / den as f64 / (1_i64 << 60) as f64 / S::unit(at)
}

/// Sixteen bodies from 20 to 100 m away on either side, at up to 12 m/s.
fn steady<S: Format>() -> Scene<S> {
    let place = |i: usize| (20.0 + 80.0 * spread(i)) * if i.is_multiple_of(2) { 1.0 } else { -1.0 };
    let speed = |i: usize| 24.0 * spread(i + 48) - 12.0;
    let pair = |f: &dyn Fn(usize) -> f64, i| [f(i), f(i + 16)];
    world(std::array::from_fn(|i| {
        point(pair(&place, i), pair(&speed, i), 1.0)
    }))
}

type Scene<S> = World<Point<S>, 16>;

/// What the methods themselves make of a step; `Chosen` would take the default.
fn picture<S: Format>(
    scheme: Scheme,
    [before, after]: [&Scene<S>; 2],
    between: &Between<S>,
) -> Vec<(BodyId, Vec2<S>)> {
    match scheme {
        Scheme::Euler => after.between(before, &Euler::new(), between).collect(),
        Scheme::ConstantAcceleration => {
            let method = ConstantAcceleration::new();
            after.between(before, &method, between).collect()
        }
        Scheme::SemiImplicitEuler => {
            let method = SemiImplicitEuler;
            after.between(before, &method, between).collect()
        }
        Scheme::Verlet => after.between(before, &Verlet, between).collect(),
        Scheme::Rk4 => after.between(before, &Rk4::new(), between).collect(),
        Scheme::Pefrl => after.between(before, &Pefrl::new(), between).collect(),
    }
}

/// One coordinate of one body: before, after, drawn, and its velocity.
struct Drawn<S> {
    states: [S; 2],
    drawn: S,
    velocity: S,
}

impl<S: Format> Drawn<S> {
    /// The largest distance from the origin, where a float has its largest unit.
    fn reach(&self) -> f64 {
        let [before, after] = self.states.map(|x| x.to_f64().abs());
        before.max(after)
    }

    /// Units by which `COEFFICIENT` of the way may move it.
    fn slack(&self) -> f64 {
        let way = self.velocity.to_f64().abs() / f64::from(RATE);
        S::COEFFICIENT * way / S::unit(self.reach())
    }
}

/// All bodies after one step, at `part` of it, both axes.
fn drawn<S: Format>(scheme: Scheme, part: Ratio) -> Vec<Drawn<S>> {
    let (step, mut world) = (Step::hz(RATE).unwrap(), steady::<S>());
    let (before, mut method) = (world.clone(), scheme.method());
    world.step(&mut method, &mut (), &step);
    let between = Between::new(part, &step).unwrap();
    let mut all = Vec::new();
    for (id, at) in picture(scheme, [&before, &world], &between) {
        let [before, after] = [&before, &world].map(|world| world.get(id).unwrap());
        let [x0, x1, v] = [before.position(), after.position(), after.velocity()];
        let axis = |x0, x1, drawn, velocity| Drawn {
            states: [x0, x1],
            drawn,
            velocity,
        };
        all.extend([axis(x0.x, x1.x, at.x, v.x), axis(x0.y, x1.y, at.y, v.y)]);
    }
    assert_eq!(all.len(), 32);
    all
}

// One rounding: half a unit. The part is a coefficient, off by half a COEFFICIENT of the way. In
// floats the difference is exact, as neither of its terms is twice the other, and its product with
// the part rounds by as much again.
fn is_rounded_once<S: Format>(scheme: Scheme) {
    let mut errors = Vec::new();
    for part in parts() {
        let (num, den) = (i128::from(part.num()), i128::from(part.den()));
        for body in drawn::<S>(scheme, part) {
            let [x0, x1] = body.states.map(|x| scaled(x.to_f64()));
            let exact = x0 * den + num * (x1 - x0);
            let error = off(body.drawn, exact, den, body.reach());
            errors.push(error / (0.5 + body.slack()));
            let [before, after] = body.states;
            assert!(num != 0 || body.drawn == before);
            assert!(num != den || body.drawn == after);
        }
    }
    let what = format!("{} {scheme:?} on the chord, of the bound", S::name());
    within(1.0, &what, &errors);
}

#[test]
fn a_steady_body_is_drawn_where_it_is_rounded_once() {
    for scheme in SCHEMES {
        is_rounded_once::<f32>(scheme);
        is_rounded_once::<f64>(scheme);
        is_rounded_once::<I16F16>(scheme);
        is_rounded_once::<I12F20>(scheme);
        is_rounded_once::<I8F24>(scheme);
        is_rounded_once::<I20F12>(scheme);
    }
}

/// Quarters of a way are exact coefficients: the very bits, ties away from the body's start.
fn has_the_bits<S: Grid>() {
    for part in parts().into_iter().filter(|part| part.den() != 10) {
        let (num, den) = (i128::from(part.num()), i128::from(part.den()));
        for body in SCHEMES.iter().flat_map(|&s| drawn::<S>(s, part)) {
            let [x0, x1] = body.states.map(|x| i128::from(x.units()));
            let way = num * (x1 - x0);
            let rounded = (2 * way.abs() + den) / (2 * den) * way.signum();
            assert_eq!(i128::from(body.drawn.units()), x0 + rounded);
        }
    }
}

#[test]
fn quarters_of_a_step_are_the_nearest_values_bit_by_bit() {
    has_the_bits::<I16F16>();
    has_the_bits::<I12F20>();
    has_the_bits::<I8F24>();
    has_the_bits::<I20F12>();
}

// The step rounds x once per drift, of which a part is seen; the picture once more. h, the part
// and, in floats, their products: a COEFFICIENT of the way each. 2^-29 of it is what one span is off
// by, 4/3 of a fixed COEFFICIENT.
fn is_on_the_line<S: Format>(scheme: Scheme) {
    let mut errors = Vec::new();
    let rate = i128::from(RATE);
    for part in parts() {
        let (num, den) = (i128::from(part.num()), i128::from(part.den()));
        for body in drawn::<S>(scheme, part) {
            let (x0, v) = (body.states[0].to_f64(), body.velocity.to_f64());
            let exact = scaled(x0) * den * rate + num * scaled(v);
            let error = off(body.drawn, exact, den * rate, body.reach());
            let step = part.to_f64() * 0.5 * scheme.drifts();
            errors.push(error / (0.5 + step + 3.0 * body.slack()));
        }
    }
    let what = format!("{} {scheme:?} on the line, of the bound", S::name());
    within(1.0, &what, &errors);
}

#[test]
fn a_steady_body_is_drawn_on_its_line() {
    for scheme in SCHEMES {
        is_on_the_line::<f32>(scheme);
        is_on_the_line::<f64>(scheme);
        is_on_the_line::<I16F16>(scheme);
        is_on_the_line::<I12F20>(scheme);
        is_on_the_line::<I8F24>(scheme);
        is_on_the_line::<I20F12>(scheme);
    }
}
