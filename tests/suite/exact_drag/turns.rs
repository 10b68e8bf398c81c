//! Quadratic drag keeps the direction of a velocity.
//!
//! Both parts of v shrink by one factor, so what is across the exact direction shrinks as v does, and
//! the angle stays. A part of a step rounds each component by half a unit, or takes a whole one where
//! it would take none: up to `1.42` units across, an angle of `1.42/|v|`. Floats round the loss, which is
//! less than v, and the new v, by half an epsilon each of the component as it was: 1.42 units of it.

use super::{RATE, floats, grid, parts};
use crate::support::*;
use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{Decay, ExactQuadraticDrag, Step};

/// From `2^24` units on, as long as 2^6 are left.
fn turned<S: Format + Decay>(scheme: Scheme, q: f64, angle: f64) -> f64 {
    let unit = if floats::<S>() {
        2.0_f64.powi(-16)
    } else {
        S::unit(0.0)
    };
    let size = 2.0_f64.powi(24) * unit;
    let mut world = world([point::<S>(
        [0.0; 2],
        [size * angle.cos(), size * angle.sin()],
        1.0,
    )]);
    let start = world.bodies()[0].velocity().to_f64();
    let mut force = ExactQuadraticDrag::new(ratio(q * RATE / size)).unwrap();
    let (mut method, step) = (scheme.method(), Step::hz(RATE as i32).unwrap());
    let (mut allowed, mut worst, mut before) = (0.0, 0.0_f64, start);
    for _ in 0..200 {
        world.step(&mut method, &mut force, &step);
        let v = world.bodies()[0].velocity().to_f64();
        if v.length() < 64.0 * unit {
            break;
        }
        let across = (start.x * v.y - start.y * v.x) / start.length() / v.length();
        let rounding = if floats::<S>() {
            S::unit(before.length())
        } else {
            unit
        };
        allowed += f64::from(parts(scheme)) * 1.42 * rounding / v.length();
        // An f64 of the reference rounds its products too.
        worst = maximum(&[worst, across.abs() / (allowed + 2.0 * f64::EPSILON)]);
        before = v;
    }
    worst
}

fn check<S: Format + Decay>() {
    for scheme in SCHEMES {
        let shares = grid(0.01, 1000.0, 6).flat_map(|q| (0..16).map(move |i| (q, angle(i))));
        let shares: Vec<f64> = shares
            .map(|(q, angle)| turned::<S>(scheme, q, angle))
            .collect();
        within(
            1.0,
            &format!("{} {scheme:?} turned, of its bound", S::name()),
            &shares,
        );
    }
}

#[test]
fn quadratic_drag_keeps_the_direction() {
    check::<f32>();
    check::<I16F16>();
    check::<I8F24>();
}
