//! `ExactQuadraticDrag` alone, against `v0 / (1 + c v0 t / m)`: q is `h c v / m`, `E = sqrt(m/(c h))`
//! in units, with h the length of a part.
//!
//! What two speeds v and w differ by shrinks to a `(1 + v/E²)(1 + w/E²)`th. A point rounds to half a unit
//! as long as that is one, from `v = 0.71 E + 1/4` on, so that above v is off by at most
//! `(1 + 0.71/E) E/1.41 = 0.71 E + 1/2` too fast, and by `0.36 E + 1` too slow, where both shrink it.
//! Below it falls by a unit a part, faster than the exact w. From `w = 1.06 E` on, w is at
//! `1.06/(1 + 1.06 * 0.71) E = 0.61 E` when v has come to rest. In all `0.75 E + 1`: within E where a
//! part is a step and E is 4 or more; two parts have an E of their own, 1.41 times that of a step.
//! A point in fixed point comes to rest; the exact speed does not.
//!
//! A carried body takes the speed rounded: q is off by `1/(2 v)` of itself, `q/(1 + q)²/2` units a part,
//! which the shrinking keeps below a quarter; half a unit where it is read and `2^-15` a part.
//!
//! Coefficients are off by a part of what is lost; floats round that and the new v. Both go through
//! `b' = b/(1 + q)² + ...` beside the exact speed.

use super::{RATE, coefficients, floats, grid, parts};
use crate::support::*;
use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{
    Body, Carried, Decay, ExactQuadraticDrag, Point, QuadraticDrag, Scalar, SemiImplicitEuler,
    Step, World,
};

const STEPS: u32 = 200;

/// Error and bound, in units, at the worst step of a body and its mirror image.
struct Run {
    /// Share of what rounding and coefficients may cost.
    share: f64,
    worst: f64,
    /// Whether the last velocity is zero.
    rests: bool,
}

/// `q` is that of the first step; `units` may be lost to rounding in fixed point, for an E of a part.
fn run<B>(scheme: Scheme, q: f64, start: f64, mass: f64, units: fn(f64) -> f64) -> Run
where
    B: Body<S: Format + Decay> + From<Point<B::S>> + std::fmt::Debug,
{
    let (p, unit) = (parts(scheme), B::S::unit(0.0));
    let drag = mass * q * RATE / start;
    let per_part = q / start / f64::from(p);
    let mut world: World<B, 2> =
        world([start, -start].map(|v| point([0.0; 2], [v, 0.0], mass).into()));
    let mut force = ExactQuadraticDrag::new(ratio(drag)).unwrap();
    let (mut method, step) = (scheme.method(), Step::hz(RATE as i32).unwrap());
    let allowed = units((1.0 / (per_part * unit)).sqrt()) * unit;
    let (mut exact, mut off, mut last) = (start, 0.0, start);
    let (mut share, mut worst) = (0.0_f64, 0.0_f64);
    for _ in 0..STEPS {
        world.step(&mut method, &mut force, &step);
        for _ in 0..p {
            let next = exact / (1.0 + per_part * exact);
            off = off * (next / exact).powi(2) + (exact - next) * coefficients::<B::S>();
            if floats::<B::S>() {
                off += next * B::S::unit(1.0);
            }
            exact = next;
        }
        let [v, mirror] = [0, 1].map(|i| world.bodies()[i].velocity().x.to_f64());
        assert!(
            0.0 <= v && v <= last && mirror == -v,
            "{last} became {v}, {mirror}"
        );
        last = v;
        let error = (v - exact).abs();
        let bound = if floats::<B::S>() { off } else { allowed + off };
        share = maximum(&[share, error / bound]);
        worst = maximum(&[worst, error / unit]);
    }
    Run {
        share,
        worst,
        rests: last == 0.0,
    }
}

/// Sixteen starts from 2^16 units, where an E of a step is 8 units at q 1000, to 2^30.
fn starts<S: Format>(most: f64) -> impl Iterator<Item = f64> {
    let unit = if floats::<S>() {
        2.0_f64.powi(-16)
    } else {
        S::unit(0.0)
    };
    (0..16).map(move |i| {
        let size: S = scalar(2.0_f64.powf(16.0 + (most - 16.0) * i as f64 / 15.0).floor() * unit);
        size.to_f64()
    })
}

/// 26 values of `h c v / m` at the start, and masses with exact inverses.
fn rates() -> impl Iterator<Item = (f64, f64)> {
    grid(0.01, 1000.0, 26).zip([1.0, 0.25, 8.0].into_iter().cycle())
}

fn check_point<S: Format + Decay>() {
    for scheme in SCHEMES {
        let (mut shares, mut of_step, mut rested) = (vec![], vec![], 0);
        for (q, mass) in rates() {
            for start in starts::<S>(30.0) {
                let run = run::<Point<S>>(scheme, q, start, mass, |e| 0.75 * e + 1.0);
                shares.push(run.share);
                rested += u32::from(run.rests);
                let e = (start / q / S::unit(0.0)).sqrt();
                of_step.push((run.worst - start / S::unit(0.0) * coefficients::<S>()) / e);
            }
        }
        let name = format!("{} {scheme:?}", S::name());
        within(1.0, &format!("{name} point, of its bound"), &shares);
        if !floats::<S>() {
            let bound = if parts(scheme) == 1 { 1.0 } else { 1.25 };
            within(
                bound,
                &format!("{name} point, in sqrt(LSB / (κ h))"),
                &of_step,
            );
            assert!(rested >= 16, "{name}: {rested} came to rest");
        }
    }
}

#[test]
fn points_follow_the_hyperbola() {
    check_point::<f32>();
    check_point::<I16F16>();
    if LAB {
        check_point::<f64>();
        check_point::<I8F24>();
    }
}

fn check_carried<S: Format + Decay + fixstep::Carry>() {
    for scheme in SCHEMES {
        let (mut shares, mut small) = (vec![], vec![]);
        for (q, mass) in rates() {
            // 400 parts of 2^-15.
            let units = |_: f64| 0.75 + 2.0 * f64::from(STEPS) / 32768.0;
            let all =
                starts::<S>(30.0).map(|start| run::<Carried<S>>(scheme, q, start, mass, units));
            shares.extend(all.map(|run| run.share));
            // Coefficients cost 2^24 of them at most, 0.19 units.
            let all =
                starts::<S>(24.0).map(|start| run::<Carried<S>>(scheme, q, start, mass, units));
            small.extend(all.map(|run| run.worst));
        }
        let name = format!("{} {scheme:?} carried", S::name());
        within(1.0, &format!("{name}, of its bound"), &shares);
        if !floats::<S>() {
            within(1.0, &format!("{name}, units up to 2^24"), &small);
        }
    }
}

#[test]
fn carried_bodies_are_within_a_unit_of_the_hyperbola() {
    check_carried::<f32>();
    check_carried::<I16F16>();
    if LAB {
        check_carried::<f64>();
        check_carried::<I8F24>();
    }
}

/// At `q = 100` an explicit step makes v 99 times as fast as it was, backwards. The next kicks are out of
/// range: in fixed point each has the size of the largest number, there and back for ever.
fn check_explicit<S: Format>() {
    let mut world = world([point::<S>([0.0; 2], [1.0, 0.0], 1.0)]);
    let mut force = QuadraticDrag::new(ratio(100.0 * RATE)).unwrap();
    let step = Step::hz(RATE as i32).unwrap();
    let mut speeds = vec![1.0];
    for _ in 0..12 {
        world.step(&mut SemiImplicitEuler, &mut force, &step);
        speeds.push(world.bodies()[0].velocity().x.to_f64());
    }
    assert!((speeds[1] + 99.0).abs() <= 1e-4, "{speeds:?}");
    if floats::<S>() {
        assert!(!speeds[12].is_finite(), "{speeds:?}");
        return;
    }
    let most = S::MAX.to_f64();
    for pair in speeds[1..].windows(2) {
        assert_eq!((pair[1] - pair[0]).abs(), most, "{} {speeds:?}", S::name());
    }
}

#[test]
fn the_explicit_force_leaves_the_range_where_the_exact_one_is_sane() {
    check_explicit::<f32>();
    check_explicit::<I16F16>();
    check_explicit::<I8F24>();
}
