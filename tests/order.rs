//! A forced spring, x'' = -k x + A cos(w t): every method shows its own order in h.
//!
//! ```text
//! x(t) = (x0 - B) cos(ω t) + v0/ω sin(ω t) + B cos(w t)
//! y(t) = y0 cos(ω t) + (vy0 - B w)/ω sin(ω t) + B sin(w t)       B = A / (ω² - w²)
//! ```

mod support;

use fixstep::fixed::types::{I8F24, I12F20, I16F16};
use fixstep::{Anchor, PerBody, Point, Scalar, Step, Time, Vec2, World};
use support::*;

const STIFFNESS: f64 = 9.7;
const AMPLITUDE: f64 = 6.0;
const FREQUENCY: f64 = 1.618;
const SECONDS: i32 = 2;

/// Steps per second: primes, so that no step is a fraction of a period. With ω T = 6 the methods
/// that gain energy need ω² h T / 2 < 0.1 for their leading term, from 101 Hz; the symplectic one of
/// order 1 needs ω h < 0.05, from 61 Hz; that of order 2 needs ω h < 0.2, from 17 Hz.
const FINE: [i32; 8] = [101, 139, 191, 263, 367, 509, 701, 967];
const MIDDLE: [i32; 8] = [61, 83, 113, 151, 211, 283, 389, 541];
const COARSE: [i32; 8] = [17, 23, 31, 43, 59, 83, 113, 157];

type Forced<S> = World<Point<S>, 8>;

/// Sixteen starts: two axes of eight bodies, amplitudes of 25 m and so of 78 m/s.
fn forced<S: Format>() -> Forced<S> {
    let omega = STIFFNESS.sqrt();
    let part = |i: usize| [25.0 * angle(i).cos(), 25.0 * omega * angle(i).sin()];
    world(std::array::from_fn(|i| {
        let (x, y) = (part(2 * i), part(2 * i + 1));
        point([x[0], y[0]], [x[1], y[1]], 1.0)
    }))
}

/// A (cos w t, sin w t), from the exact count of half ticks.
fn drive<S: Scalar>(time: Time) -> Vec2<S> {
    let phase = FREQUENCY * time.elapsed().unwrap().to_f64();
    vector(AMPLITUDE * phase.cos(), AMPLITUDE * phase.sin())
}

/// The exact position at time `t` of a body that started as `start`.
fn exact<S: Scalar>(start: &Point<S>, t: f64) -> [f64; 2] {
    let (x0, v0) = (start.position().to_f64(), start.velocity().to_f64());
    let omega = STIFFNESS.sqrt();
    let b = AMPLITUDE / (STIFFNESS - FREQUENCY * FREQUENCY);
    let (sin, cos) = (omega * t).sin_cos();
    let (drive_sin, drive_cos) = (FREQUENCY * t).sin_cos();
    let x = (x0.x - b) * cos + v0.x / omega * sin + b * drive_cos;
    let y = x0.y * cos + (v0.y - b * FREQUENCY) / omega * sin + b * drive_sin;
    [x, y]
}

/// The largest error of each of the sixteen swings over `SECONDS` at `rate`.
fn errors<S: Format>(scheme: Scheme, rate: i32) -> [f64; 16] {
    let mut world = forced::<S>();
    let start = world.clone();
    let anchors: [Anchor<S>; 8] = anchors(&world, [STIFFNESS; 8]);
    let mut forces = (
        anchors,
        PerBody(|time: Time, _: &Point<S>| drive::<S>(time)),
    );
    let (mut method, step) = (scheme.method(), Step::hz(rate).unwrap());
    let mut worst = [0.0; 16];
    for tick in 1..=rate * SECONDS {
        world.step(&mut method, &mut forces, &step);
        for (i, (now, start)) in world.bodies().iter().zip(start.bodies()).enumerate() {
            let exact = exact(start, tick as f64 / rate as f64);
            let x = now.position().to_f64().array();
            for axis in 0..2 {
                let error = &mut worst[2 * i + axis];
                *error = maximum(&[*error, (x[axis] - exact[axis]).abs()]);
            }
        }
    }
    worst
}

/// Six standard deviations of rounding at `rate`, in m. A step is close to a rotation in (x, v/ω):
/// its roundings add up as they are, 1/12 of a unit² for each drift and each of four products of
/// the two kicks. Coefficients that are off by `COEFFICIENT` shift the phase by ω T times that.
fn floor<S: Format>(scheme: Scheme, rate: i32) -> f64 {
    let omega = STIFFNESS.sqrt();
    let (x, u) = (S::unit(26.0), S::unit(26.0 * omega) / omega);
    let steps = (rate * SECONDS) as f64;
    let variance = steps / 12.0 * (scheme.drifts() * x * x + 4.0 * u * u);
    6.0 * variance.sqrt() + 26.0 * omega * SECONDS as f64 * S::COEFFICIENT
}

/// Slope of ln(error) against ln(h), least squares.
fn slope(points: &[(f64, f64)]) -> f64 {
    let count = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (mx, my) = (mean(|p| p.0), mean(|p| p.1));
    let covariance: f64 = points.iter().map(|(x, y)| (x - mx) * (y - my)).sum();
    covariance / points.iter().map(|(x, _)| (x - mx) * (x - mx)).sum::<f64>()
}

/// The slope is taken where the error is more than 20 times the rounding, which then moves it by
/// less than 0.05 over the factor of 2.5 in h that three points span; the next term of the
/// method's own error is up to 0.1 of the first at the coarsest rate.
/// At every rate, down to the floor and below it, the error is not more than the coarsest rate's
/// promises, a third more for that next term, and rounding.
fn check<S: Format>(scheme: Scheme, order: f64, rates: [i32; 8]) {
    let floors = rates.map(|rate| floor::<S>(scheme, rate));
    let table = rates.map(|rate| errors::<S>(scheme, rate));
    let off = |i: usize| {
        let above = (0..8).filter(|&k| table[k][i] >= 20.0 * floors[k]);
        let points: Vec<_> = above
            .map(|k| (-(rates[k] as f64).ln(), table[k][i].ln()))
            .collect();
        assert!(
            points.len() >= 3,
            "{} {scheme:?}: {} points above rounding",
            S::name(),
            points.len()
        );
        (slope(&points) - order).abs()
    };
    let promised = |i: usize, k: usize| {
        table[0][i] * (rates[0] as f64 / rates[k] as f64).powf(order) * 4.0 / 3.0 + floors[k]
    };
    let slopes: [f64; 16] = std::array::from_fn(off);
    let excess: [f64; 16] = std::array::from_fn(|i| {
        maximum(&std::array::from_fn::<f64, 7, _>(|k| {
            table[k + 1][i] / promised(i, k + 1)
        }))
    });
    within(
        0.1,
        &format!("{} {scheme:?} slope less {order}", S::name()),
        &slopes,
    );
    within(
        1.0,
        &format!("{} {scheme:?} error, of the promise", S::name()),
        &excess,
    );
}

fn check_scalars(scheme: Scheme, order: f64, rates: [i32; 8]) {
    check::<f32>(scheme, order, rates);
    check::<f64>(scheme, order, rates);
    check::<I16F16>(scheme, order, rates);
    check::<I12F20>(scheme, order, rates);
    check::<I8F24>(scheme, order, rates);
}

#[test]
fn euler_has_order_1() {
    check_scalars(Scheme::Euler, 1.0, FINE);
}

#[test]
fn constant_acceleration_has_order_1() {
    check_scalars(Scheme::ConstantAcceleration, 1.0, FINE);
}

#[test]
fn semi_implicit_euler_has_order_1() {
    check_scalars(Scheme::SemiImplicitEuler, 1.0, MIDDLE);
}

#[test]
fn verlet_has_order_2() {
    check_scalars(Scheme::Verlet, 2.0, COARSE);
}
