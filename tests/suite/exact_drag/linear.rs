//! `ExactDrag` alone, against `v0 exp(-k t / m)` at every step.
//!
//! A point in fixed point loses `l v` rounded, and one unit where that is none. Where it rounds,
//! `e' = (1 - l) e + 1/2` at most, so `|e| <= 1/(2 l)`. Below `v = 1/(2 l)` it falls by a unit a part,
//! more than the exact w: what is above w comes closer, and
//!
//! ```text
//! w - v = (v0 + 1/(2 l)) exp(-l j) - v0 + j        after j <= v0 parts
//! ```
//!
//! is convex in j, and at its end, `v = 0`, largest for `v0 = 1/(2 l)`: `exp(-1/2)/l = 0.61/l` units
//! bound all errors. With one part that is at most `1/x` for x up to 1, from where half a unit and a bit
//! is as near as whole units come; with two it is `1.22/x` and more: the halves round twice. Every
//! part takes a unit or more, so v is 0 after `1 + 1/(2 l)` parts more than w takes to one unit.
//!
//! A body that carries rounds to `2^-15` units: `2^-15/l`, and half a unit where it is read.
//!
//! Floats round the loss and the new v, a half epsilon each: the first counts as the coefficient's error
//! does, the second in what is left. An error of the loss is one of `n (1 - l)^(n-1) l` at most, after n
//! parts, relatively.

use super::{RATE, coefficients, floats, grid, parts};
use crate::support::*;
use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{Body, Carried, Decay, ExactDrag, Point, Step, World};

/// Start `i` of 32: sixteen sizes from 2 units to `2^30`, in floats from `2^-15` to `2^14`; both signs.
fn starts<S: Format>(most: f64) -> [f64; 32] {
    let unit = if floats::<S>() {
        2.0_f64.powi(-16)
    } else {
        S::unit(0.0)
    };
    std::array::from_fn(|i| {
        let size = (2.0_f64.powf(1.0 + (most - 1.0) * spread(i / 2))).round() * unit;
        let size: S = scalar(size);
        if i % 2 == 0 {
            size.to_f64()
        } else {
            -size.to_f64()
        }
    })
}

/// What a run is held against.
struct Bounds {
    /// Units that rounding may cost, beside coefficients.
    units: f64,
    /// Whether every start comes to rest.
    rests: bool,
}

/// The largest share of the bound, over all starts and steps; and the largest error in units.
fn decayed<B>(scheme: Scheme, x: f64, mass: f64, most: f64, bounds: &Bounds) -> (Vec<f64>, f64)
where
    B: Body<S: Format + Decay> + From<Point<B::S>> + std::fmt::Debug,
{
    let (starts, p) = (starts::<B::S>(most), f64::from(parts(scheme)));
    let unit = B::S::unit(0.0);
    let mut world: World<B, 32> = world(starts.map(|v| point([0.0; 2], [v, -v], mass).into()));
    let mut drag = ExactDrag::new(ratio(x * mass * RATE)).unwrap();
    let (mut method, step) = (scheme.method(), Step::hz(RATE as i32).unwrap());
    let (loss, float) = (-(-x / p).exp_m1(), floats::<B::S>());
    let slack = 1.0 / x + 2.0;
    let steps =
        (((most + 1.0) * 0.7 / x + slack).ceil() as u32).min(if float { 2000 } else { u32::MAX });
    let (mut shares, mut worst, mut last) = (vec![0.0_f64; 32], 0.0_f64, starts);
    let mut gone = [f64::INFINITY; 32];
    for n in (1..=steps).map(f64::from) {
        world.step(&mut method, &mut drag, &step);
        let (left, done) = ((-x * n).exp(), p * n);
        let part = done * (-x * (n - 1.0 / p)).exp() * loss;
        for (i, body) in world.bodies().iter().enumerate() {
            let (v, start) = (body.velocity().to_f64(), starts[i]);
            assert!(v.y == -v.x && v.x * start >= 0.0, "{start} became {v:?}");
            assert!(v.x.abs() <= last[i].abs(), "{} became {v:?}", last[i]);
            last[i] = v.x;
            let coefficient = start.abs() * part * coefficients::<B::S>();
            let rounding = match float {
                true => start.abs() * (part + done * left) * B::S::unit(1.0),
                false => bounds.units * unit,
            };
            let error = (v.x - start * left).abs();
            shares[i] = maximum(&[shares[i], error / (coefficient + rounding)]);
            worst = maximum(&[worst, error / unit]);
            if (start * left).abs() < unit {
                gone[i] = gone[i].min(n);
            }
            let late = bounds.rests && n >= gone[i] + slack;
            assert!(!late || v.x == 0.0, "{start} is still {v:?} at step {n}");
        }
    }
    (shares, worst)
}

/// Masses whose inverses are exact.
const MASSES: [f64; 4] = [1.0, 0.25, 8.0, 2.0];

fn rates() -> impl Iterator<Item = (f64, f64)> {
    grid(0.01, 100.0, 26).zip(MASSES.into_iter().cycle())
}

fn check_point<S: Format + Decay>() {
    for scheme in ALL_SCHEMES {
        let p = f64::from(parts(scheme));
        let (mut all, mut of_step) = (vec![], 0.0_f64);
        for (x, mass) in rates() {
            let units = (-0.5_f64).exp() / -(-x / p).exp_m1();
            let rests = !floats::<S>();
            let bounds = Bounds { units, rests };
            all.extend(decayed::<Point<S>>(scheme, x, mass, 30.0, &bounds).0);
            // Up to 2^20 units coefficients do not count: what is left is rounding.
            if rests && x <= 1.0 {
                of_step = of_step.max(x * decayed::<Point<S>>(scheme, x, mass, 20.0, &bounds).1);
            }
        }
        let name = format!("{} {scheme:?}", S::name());
        within(1.0, &format!("{name} point, of its bound"), &all);
        if !floats::<S>() {
            println!("{name}: error times k h / m at most {of_step:.3} units up to k h / m = 1");
        }
        // n l (1 - l)^(n-1) is at most 1, so coefficients cost 2^20 of them: 0.012 units. In two
        // parts 0.61/l is 1.55/x at x = 1.
        assert!(of_step <= if p == 1.0 { 1.012 } else { 1.57 });
    }
}

#[test]
fn points_decay_as_the_exponential() {
    check_point::<f32>();
    check_point::<I16F16>();
    if LAB {
        check_point::<f64>();
        check_point::<I8F24>();
    }
}

fn check_carried<S: Format + Decay + fixstep::Carry>() {
    for scheme in ALL_SCHEMES {
        let p = f64::from(parts(scheme));
        let (mut all, mut small) = (vec![], vec![]);
        for (x, mass) in rates() {
            let units = 0.5 + 2.0_f64.powi(-15) / -(-x / p).exp_m1();
            let rests = !floats::<S>();
            let bounds = Bounds { units, rests };
            all.extend(decayed::<Carried<S>>(scheme, x, mass, 30.0, &bounds).0);
            if rests {
                // Coefficients cost 2^24 of them at most: 0.19 units.
                small.push(decayed::<Carried<S>>(scheme, x, mass, 24.0, &bounds).1);
            }
        }
        let name = format!("{} {scheme:?} carried", S::name());
        within(1.0, &format!("{name}, of its bound"), &all);
        if !small.is_empty() {
            within(1.0, &format!("{name}, units up to 2^24"), &small);
        }
    }
}

#[test]
fn carried_bodies_are_within_a_unit_of_the_exponential() {
    check_carried::<f32>();
    check_carried::<I16F16>();
    if LAB {
        check_carried::<f64>();
        check_carried::<I8F24>();
    }
}
