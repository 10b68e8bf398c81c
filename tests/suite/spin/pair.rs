//! Why an angle is a count of parts of a turn: what a cosine and a sine, kept instead of it, drift by.
//!
//! ```text
//! q' = q + h ω perp(q),  q'' = q' (3 - |q'|²) / 2        turns by atan(h ω): a third of (h ω)³ too little
//! q' = q cos(h ω) + perp(q) sin(h ω), the same           both made anew where the spin changes
//! ```
//!
//! Source of the first: `b2IntegrateRotation` of Box2D, with a step of Newton's method for the inverse root
//! in place of a root and a division.

use std::f64::consts::TAU;

use super::*;

const STEPS: u64 = 1_000_000;

const ONE: i64 = 1 << 30;

fn nearest(value: f64) -> i64 {
    (value * ONE as f64).round() as i64
}

fn product(a: i64, b: i64) -> i64 {
    (a * b + ONE / 2) >> 30
}

/// A direction in units of 2^-30, and the turns that it has made.
struct Direction {
    cos: i64,
    sin: i64,
    turns: i64,
}

impl Direction {
    /// Turned by `[cos, sin]`, of any length near one, and made a unit long again.
    fn turn(&mut self, [cos, sin]: [i64; 2]) {
        let x = product(cos, self.cos) - product(sin, self.sin);
        let y = product(cos, self.sin) + product(sin, self.cos);
        let inverse = (3 * ONE - product(x, x) - product(y, y)) / 2;
        let (x, y) = (product(x, inverse), product(y, inverse));
        // Upwards through the x axis: a step is less than half a turn.
        self.turns += (self.sin < 0 && y >= 0) as i64;
        (self.cos, self.sin) = (x, y);
    }

    /// How far it is from `turns` after a million steps by `[cos, sin]`.
    fn off(by: [f64; 2], turns: f64) -> f64 {
        let mut direction = Direction {
            cos: ONE,
            sin: 0,
            turns: 0,
        };
        let by = by.map(nearest);
        (0..STEPS).for_each(|_| direction.turn(by));
        let part = (direction.sin as f64).atan2(direction.cos as f64) / TAU;
        let part = if part < 0.0 { part + 1.0 } else { part };
        (direction.turns as f64 + part - turns).abs()
    }
}

fn count<C: Centre<S: Angular> + From<Point<C::S>>>(spin: f64) -> f64 {
    let (mut body, step) = (spinning::<C>(spin), Step::hz(60).unwrap());
    (0..STEPS).for_each(|_| body.drift(&step));
    let exact = flow(body.spin().to_f64(), step.seconds(), STEPS);
    apart(all_bits(&body), exact).abs()
}

/// The second rounds six products of a step, a cosine and a sine: four units of 2^-30 rad across the direction
/// at most, all one way.
#[test]
fn a_kept_direction_drifts_a_hundred_times_as_far() {
    println!("turns off after a million steps at 60 Hz");
    println!("turns/s   h ω perp   cos, sin  Point I16F16  Carried I16F16");
    for spin in [0.1_f64, 1.0, 10.0] {
        let (turns, angle) = (STEPS as f64 * spin / 60.0, TAU * spin / 60.0);
        let small = Direction::off([1.0, angle], turns);
        let full = Direction::off([angle.cos(), angle.sin()], turns);
        let (plain, carried) = (count::<Point<I16F16>>(spin), count::<Carried<I16F16>>(spin));
        println!("{spin:>7} {small:>10.3e} {full:>10.2e} {plain:>13.2e} {carried:>15.2e}");

        // What is left over of h ω is that of its tangent.
        let tangent = STEPS as f64 * (angle - angle.atan()) / TAU;
        let rounded = STEPS as f64 * 4.0 / ONE as f64 / TAU;
        assert!((small - tangent).abs() <= rounded, "{small} {tangent}");
        assert!(full <= rounded, "{full}");
        assert!(small >= 100.0 * plain && small >= 100.0 * carried);
    }
}
