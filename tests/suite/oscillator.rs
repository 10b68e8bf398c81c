//! An undamped spring, with q = ω h and u = v/ω:
//!
//! ```text
//! Euler               x' = x + q u    u' = u - q x     x² + u² grows by 1 + q² a step
//! SemiImplicitEuler   u' = u - q x    x' = x + q u'    keeps x² + u² - q x u
//! Verlet              half drifts around u' = u - q x  keeps x² + (1 - q²/4) u²
//! ```
//!
//! The kept forms are ellipses for q < 2 and hyperbolas above.

use crate::support;

use fixstep::fixed::types::{I8F24, I12F20, I16F16, I20F12};
use fixstep::{Anchor, Point, Scalar, Step, World};
use support::*;

const RATE: f64 = 60.0;

/// Up to where the bodies may swing: half of the range, and 1000 m (m/s) where that is more.
fn room<S: Scalar>() -> f64 {
    (0.5 * S::MAX.to_f64()).min(1000.0)
}

/// A body whose x and y swing with ω h = `q`, each from its own point (x, u) of the phase plane.
fn swinging<S: Scalar>(q: f64, x: [f64; 2], y: [f64; 2]) -> Point<S> {
    let omega = q * RATE;
    point([x[0], y[0]], [x[1] * omega, y[1] * omega], 1.0)
}

fn tied<S: Scalar, const N: usize>(world: &World<Point<S>, N>, q: [f64; N]) -> [Anchor<S>; N] {
    anchors(world, q.map(|q| q * q * RATE * RATE))
}

/// x and u of both axes of every body.
fn phases<S: Scalar>(world: &World<Point<S>, 8>, q: [f64; 8]) -> [[f64; 2]; 16] {
    std::array::from_fn(|i| {
        let (body, omega) = (&world.bodies()[i / 2], q[i / 2] * RATE);
        let (x, v) = (
            body.position().to_f64().array(),
            body.velocity().to_f64().array(),
        );
        [x[i % 2], v[i % 2] / omega]
    })
}

/// ln(amplitude) grows by exactly (N/2) ln(1 + q²) in N steps: three e-foldings, the last of which
/// ends in the `room`. Rounding is most of a unit in the first steps: there the amplitude, e^-3 of
/// the room, has over 1e4 units in the coarsest case (I16F16 and I20F12: 0.02 of a range of 2^31),
/// and the coefficients are off by 1e-7: 1e-3 of the growth leaves a margin.
fn check_growth<S: Format>(q: f64) {
    let steps = (6.0 / (1.0 + q * q).ln()).round() as u32;
    let start = room::<S>() * (-3.0_f64).exp() / (q * RATE);
    let at = |i: usize| [start * angle(i).cos(), start * angle(i).sin()];
    let mut world = world(std::array::from_fn(|i| {
        swinging::<S>(q, at(2 * i), at(2 * i + 1))
    }));
    let mut forces = tied(&world, [q; 8]);
    let (mut method, step) = (Scheme::Euler.method(), Step::hz(60).unwrap());
    let before = phases(&world, [q; 8]);
    for _ in 0..steps {
        world.step(&mut method, &mut forces, &step);
    }
    let after = phases(&world, [q; 8]);
    let exact = 0.5 * steps as f64 * (1.0 + q * q).ln();
    let off = |i: usize| {
        let growth = (after[i][0].hypot(after[i][1]) / before[i][0].hypot(before[i][1])).ln();
        (growth / exact - 1.0).abs()
    };
    let errors: [f64; 16] = std::array::from_fn(off);
    within(
        1e-3,
        &format!("{} Euler wh = {q}, relative growth", S::name()),
        &errors,
    );
}

fn check_growths<S: Format>() {
    for q in [0.05, 0.1, 0.3] {
        check_growth::<S>(q);
    }
}

#[test]
fn euler_gains_amplitude_by_its_law() {
    check_growths::<f64>();
    check_growths::<f32>();
    check_growths::<I16F16>();
    check_growths::<I12F20>();
    check_growths::<I8F24>();
    check_growths::<I20F12>();
}

/// The kept form of a state, and the ends (x, u) of its ellipse of size 1.
fn kept(scheme: Scheme, q: f64, [x, u]: [f64; 2]) -> f64 {
    match scheme {
        Scheme::SemiImplicitEuler => x * x + u * u - q * x * u,
        _ => x * x + (1.0 - q * q / 4.0) * u * u,
    }
}

fn ends(scheme: Scheme, q: f64) -> [f64; 2] {
    let end = 1.0 / (1.0 - q * q / 4.0).sqrt();
    match scheme {
        Scheme::SemiImplicitEuler => [end, end],
        _ => [1.0, end],
    }
}

/// Start `i` on the ellipse that reaches to `room` in x and in v.
fn on_ellipse(scheme: Scheme, q: f64, room: f64, i: usize) -> [f64; 2] {
    let [x, u] = ends(scheme, q);
    let size = room / (x.max(u * q * RATE));
    let unit = [angle(i).cos(), angle(i).sin()];
    let scale = size / kept(scheme, q, unit).sqrt();
    unit.map(|part| part * scale)
}

/// What rounding may add to the ends after `steps`, in m. In the metric of the kept form a step is a
/// rotation, so the roundings of each step add up as they are: variance 1/12 of a unit² for each
/// drift and for two products of the kick, at most 1 + q/2 times that in the metric. Six standard
/// deviations; in floats the units are those at the ends, and the product h k, which is off by
/// `COEFFICIENT`, moves the end by that times q²/4 / (1 - q²/4).
fn rounding<S: Format>(scheme: Scheme, q: f64, ends: [f64; 2], steps: f64) -> [f64; 2] {
    let (x, u) = (
        S::unit(ends[0]),
        S::unit(2.0 * ends[1] * q * RATE) / (q * RATE),
    );
    let variance = steps / 12.0 * (scheme.drifts() * x * x + 2.0 * u * u) * (1.0 + q / 2.0);
    let stretch = 1.0 / (1.0 - q * q / 4.0);
    let coefficient = S::COEFFICIENT * q * q / 4.0 * stretch;
    ends.map(|end| 6.0 * (variance * stretch).sqrt() + coefficient * end)
}

const QS: [f64; 4] = [0.1, 1.1, 1.9, 1.99];

/// Sixteen swings, four for each of `QS`. After 10^6 steps the largest |x| and |u| of each are the
/// ends of its ellipse: not more, and, as its angle is no fraction of a turn, not less. The angle
/// of the turn nearest to an end is within 1e-3, which is 1e-6 of the end.
fn check_bounded<S: Format>(scheme: Scheme) {
    const STEPS: u32 = long(1_000_000) as u32;
    let q: [f64; 8] = std::array::from_fn(|i| QS[i / 2]);
    let at = |i: usize| on_ellipse(scheme, q[i / 2], room::<S>().min(16.0), i);
    let mut world = world(std::array::from_fn(|i| {
        swinging::<S>(q[i], at(2 * i), at(2 * i + 1))
    }));
    let mut forces = tied(&world, q);
    let (mut method, step) = (scheme.method(), Step::hz(60).unwrap());
    let before = phases(&world, q);
    let mut reach = [[0.0_f64; 2]; 16];
    for _ in 0..STEPS {
        world.step(&mut method, &mut forces, &step);
        for (reach, now) in reach.iter_mut().zip(phases(&world, q)) {
            *reach = [
                maximum(&[reach[0], now[0].abs()]),
                maximum(&[reach[1], now[1].abs()]),
            ];
        }
    }
    let off = |i: usize| {
        let q = q[i / 2];
        let size = kept(scheme, q, before[i]).sqrt();
        let ends = ends(scheme, q).map(|end| end * size);
        let allowed = rounding::<S>(scheme, q, ends, STEPS as f64);
        let part = |k: usize| (reach[i][k] - ends[k]).abs() / (allowed[k] + 1e-6 * ends[k]);
        maximum(&[part(0), part(1)])
    };
    let errors: [f64; 16] = std::array::from_fn(off);
    within(
        1.0,
        &format!("{} {scheme:?} 1e6 steps, of the allowance", S::name()),
        &errors,
    );
}

fn check_both_bounded<S: Format>() {
    check_bounded::<S>(Scheme::SemiImplicitEuler);
    check_bounded::<S>(Scheme::Verlet);
}

#[test]
fn symplectic_methods_stay_on_their_ellipse_in_floats() {
    check_both_bounded::<f32>();
    check_both_bounded::<f64>();
}

#[test]
fn symplectic_methods_stay_on_their_ellipse_in_fixed_point() {
    check_both_bounded::<I16F16>();
    check_both_bounded::<I12F20>();
    check_both_bounded::<I8F24>();
}

/// A world of sixteen swings along x with the same q, on a circle of 1/100 of the room in (x, u).
/// Phases from -60 to 20 degrees and opposite to them: above q = 2 both methods have a direction
/// that decays, at 46 and -87 degrees, and from there rounding alone would begin the growth.
fn at_rate<S: Format>(q: f64) -> (World<Point<S>, 16>, [Anchor<S>; 16]) {
    let size = 0.01 * room::<S>() / (q * RATE);
    let at = |i: usize| {
        let (sin, cos) = (-60.0 + 80.0 * spread(i)).to_radians().sin_cos();
        let size = [size, -size][i % 2];
        [size * cos, size * sin]
    };
    let world = world(std::array::from_fn(|i| swinging::<S>(q, at(i), [0.0; 2])));
    let forces = anchors(&world, [q * q * RATE * RATE; 16]);
    (world, forces)
}

/// Above q = 2 the growing part of a swing is multiplied by e^θ a step, cosh θ = q²/2 - 1. From at
/// least a quarter of the start, all phases being 26 degrees away from the decaying one, it is at
/// the end of the range after ln(4 MAX / start) / θ steps: floats become infinite by then. In fixed
/// point the impulse saturates first, at half of that, and a clamped swing may stay inside the
/// range for a while; no law says how long, but in ten times the steps every body was reported.
fn check_explosion<S: Format>(scheme: Scheme) {
    let q = 2.002;
    let (mut world, mut forces) = at_rate::<S>(q);
    let (mut method, step) = (scheme.method(), Step::hz(60).unwrap());
    let growth = (q * q / 2.0 - 1.0).acosh();
    let patience = if S::unit(1.0) == S::unit(2.0) {
        10.0
    } else {
        1.0
    };
    let limit = patience * (S::MAX.to_f64() / (0.0025 * room::<S>())).ln() / growth;
    let mut reported = [f64::INFINITY; 16];
    for tick in 1..=limit as u32 {
        world.step(&mut method, &mut forces, &step);
        for id in world.out_of_range() {
            let first = &mut reported[id.serial() as usize];
            *first = first.min(tick as f64);
        }
    }
    within(
        limit,
        &format!("{} {scheme:?} wh = {q}, steps to the end", S::name()),
        &reported,
    );
}

/// Just below q = 2 the ellipse is 1/sqrt(1 - q²/4) = 22 times as long as the circle of the start,
/// and SemiImplicitEuler's kept form is up to 1 + q/2 times its square: 32 hundredths of the room.
fn check_no_explosion<S: Format>(scheme: Scheme) {
    let (mut world, mut forces) = at_rate::<S>(1.998);
    let (mut method, step) = (scheme.method(), Step::hz(60).unwrap());
    for _ in 0..long(20_000) {
        world.step(&mut method, &mut forces, &step);
        assert_eq!(world.out_of_range().count(), 0);
        let inside = |body: &Point<S>| body.velocity().x.to_f64().abs() <= 0.33 * room::<S>();
        assert!(
            world.bodies().iter().all(inside),
            "{} {scheme:?}",
            S::name()
        );
    }
}

fn check_limit<S: Format>() {
    for scheme in [Scheme::SemiImplicitEuler, Scheme::Verlet] {
        check_explosion::<S>(scheme);
        check_no_explosion::<S>(scheme);
    }
}

#[test]
fn symplectic_methods_explode_above_two_and_not_below() {
    check_limit::<f32>();
    check_limit::<f64>();
    check_limit::<I16F16>();
    check_limit::<I12F20>();
    check_limit::<I8F24>();
    check_limit::<I20F12>();
}
