//! What the operators of `fixed` do to a motion, beside the verbs of the crate: where drag stops, a drift
//! of what should balance, and the end of the range. All in `I16F16` at 60 Hz.
//!
//! `*` of `fixed` cuts towards minus infinity. Of `v -= c v` with c = 546/65536, half a kilogram a second,
//! nothing is left for v up to 120 units above zero, as `546 * 120 < 65536`; below zero there is always a
//! unit. Rounded to nearest a loss is nothing up to 60 units, on both sides.
//!
//! A product and that of the mirrored body sum to -1 unit unless they are exact: the middle of the two
//! moves back by half a unit a step. Rounded to nearest they sum to 0.

use fixstep::fixed::types::I16F16;
use fixstep::{ExactDrag, Force, LinearDrag, Point, SemiImplicitEuler, Step, Vec2, World, dec};

use crate::support::*;

/// kg/s.
const DRAG: f64 = 0.5;
const HZ: u32 = 60;
/// m/s, of the mirrored bodies and of the one that leaves the range.
const SPEEDS: [f64; 2] = [1.2345, 1000.0];

fn seconds(steps: u32) -> f64 {
    f64::from(steps) / f64::from(HZ)
}

fn h() -> I16F16 {
    I16F16::from_num(1.0 / f64::from(HZ))
}

/// `[seconds, units]` of a speed that starts at so many units, each half second, with a step of its own.
fn speeds(start: i32, until: u32, mut next: impl FnMut(I16F16) -> I16F16) -> Vec<[f64; 2]> {
    let mut v = I16F16::from_bits(start);
    let mut found = vec![[0.0, f64::from(start)]];
    for n in 1..=until * HZ {
        v = next(v);
        if n.is_multiple_of(HZ / 2) {
            found.push([seconds(n), f64::from(v.to_bits())]);
        }
    }
    found
}

/// `v -= c * v` with the operators of `fixed`.
pub fn naive_drag(start: i32, until: u32) -> Vec<[f64; 2]> {
    let c = I16F16::from_num(DRAG / f64::from(HZ));
    speeds(start, until, |v| v - c * v)
}

fn crate_drag(start: i32, until: u32, mut drag: impl Force<Point<I16F16>>) -> Vec<[f64; 2]> {
    let step = Step::hz(ratio(f64::from(HZ))).unwrap();
    speeds(start, until, |v| {
        let body = Point::new(Vec2::ZERO, Vec2::new(v, I16F16::ZERO), 1).unwrap();
        let mut world: World<_, 1> = world([body]);
        world.step(&mut SemiImplicitEuler, &mut drag, &step);
        world.bodies()[0].velocity().x
    })
}

pub fn linear_drag(start: i32, until: u32) -> Vec<[f64; 2]> {
    crate_drag(start, until, LinearDrag::new(dec!(0.5)).unwrap())
}

pub fn exact_drag(start: i32, until: u32) -> Vec<[f64; 2]> {
    crate_drag(start, until, ExactDrag::new(dec!(0.5)).unwrap())
}

pub fn exact(start: i32, until: u32) -> Vec<[f64; 2]> {
    let at = |t: f64| [t, f64::from(start) * (-DRAG * t).exp()];
    (0..=2 * until).map(|i| at(f64::from(i) / 2.0)).collect()
}

/// `[seconds, mm]`: the middle of two bodies that start together and fly apart at one speed.
pub fn naive_middle(until: u32) -> Vec<[f64; 2]> {
    let (h, v) = (h(), I16F16::from_num(SPEEDS[0]));
    let mut x = [I16F16::ZERO; 2];
    middles(until, || {
        x[0] += h * v;
        x[1] += h * -v;
        (x[0] + x[1]).to_num::<f64>()
    })
}

pub fn crate_middle(until: u32) -> Vec<[f64; 2]> {
    let body = |v| point::<I16F16>([0.0; 2], [v, 0.0], 1.0);
    let mut world: World<_, 2> = world([SPEEDS[0], -SPEEDS[0]].map(body));
    let step = Step::hz(ratio(f64::from(HZ))).unwrap();
    middles(until, || {
        world.step(&mut SemiImplicitEuler, &mut (), &step);
        let [a, b] = [0, 1].map(|i: usize| world.bodies()[i].position().x);
        (a + b).to_num::<f64>()
    })
}

fn middles(until: u32, mut sum: impl FnMut() -> f64) -> Vec<[f64; 2]> {
    let mut found = vec![[0.0; 2]];
    for n in 1..=until * HZ {
        let middle = sum() / 2.0;
        if n.is_multiple_of(4 * HZ) {
            found.push([seconds(n), 1000.0 * middle]);
        }
    }
    found
}

/// `[seconds, km]` of a flight over the end of the range; `+` of `fixed` wraps in a release build, and
/// panics in one with checks.
pub fn naive_flight(until: u32) -> Vec<[f64; 2]> {
    let (h, v) = (h(), I16F16::from_num(SPEEDS[1]));
    let mut x = I16F16::ZERO;
    flights(until, || {
        x = x.wrapping_add(h * v);
        x.to_num()
    })
}

pub fn crate_flight(until: u32) -> Vec<[f64; 2]> {
    let mut world: World<_, 1> = world([point::<I16F16>([0.0; 2], [SPEEDS[1], 0.0], 1.0)]);
    let step = Step::hz(ratio(f64::from(HZ))).unwrap();
    flights(until, || {
        world.step(&mut SemiImplicitEuler, &mut (), &step);
        world.bodies()[0].position().x.to_num()
    })
}

fn flights(until: u32, mut position: impl FnMut() -> f64) -> Vec<[f64; 2]> {
    let mut found = vec![[0.0; 2]];
    for n in 1..=until * HZ {
        let x = position();
        if n.is_multiple_of(HZ) {
            found.push([seconds(n), x / 1000.0]);
        }
    }
    found
}
