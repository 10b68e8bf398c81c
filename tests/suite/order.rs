//! A forced spring, x'' = -k x + A cos(w t): every method shows its own order in h.
//!
//! ```text
//! x(t) = (x0 - B) cos(ω t) + v0/ω sin(ω t) + B cos(w t)
//! y(t) = y0 cos(ω t) + (vy0 - B w)/ω sin(ω t) + B sin(w t)       B = A / (ω² - w²)
//! ```

use crate::support;

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

/// Order 4 falls below rounding so soon that coarse steps must do, where ω h is 0.62 at first. Of Runge-Kutta
/// the next terms, 5/6 ω h across the swing and -0.36 (ω h)² along it, all but cancel in the size of the
/// error; those of PEFRL are of (ω h)² and small. The rates stay 4/3 apart.
const LEAST: [i32; 8] = [5, 7, 9, 12, 17, 23, 31, 43];

/// Of Runge-Kutta sums of three kicks, up to 48 m/s at 5 Hz, must fit an `I8F24`, which ends at 128 m/s.
const FITTING: [i32; 8] = [7, 9, 12, 17, 23, 31, 43, 59];

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
fn drive<S: Scalar>(amplitude: f64, time: Time) -> Vec2<S> {
    let phase = FREQUENCY * time.elapsed().unwrap().to_f64();
    vector(amplitude * phase.cos(), amplitude * phase.sin())
}

/// The exact position at time `t`, and velocity over ω, of a body that started as `start`.
fn exact<S: Scalar>(start: &Point<S>, amplitude: f64, t: f64) -> [[f64; 2]; 2] {
    let (x0, v0) = (start.position().to_f64(), start.velocity().to_f64());
    let omega = STIFFNESS.sqrt();
    let b = amplitude / (STIFFNESS - FREQUENCY * FREQUENCY);
    let (sin, cos) = (omega * t).sin_cos();
    let (drive_sin, drive_cos) = (FREQUENCY * t).sin_cos();
    let [(x, u), (y, w)] = [
        (x0.x - b, v0.x / omega),
        (x0.y, (v0.y - b * FREQUENCY) / omega),
    ];
    let share = b * FREQUENCY / omega;
    [
        [
            x * cos + u * sin + b * drive_cos,
            y * cos + w * sin + b * drive_sin,
        ],
        [
            u * cos - x * sin - share * drive_sin,
            w * cos - y * sin + share * drive_cos,
        ],
    ]
}

/// The largest error in the plane of x and v/ω of each of the sixteen swings over `SECONDS` at `rate`.
/// There the size of an error does not depend on where in its swing a coarse step meets a body.
fn errors<S: Format>(scheme: Scheme, amplitude: f64, rate: i32) -> [f64; 16] {
    let mut world = forced::<S>();
    let start = world.clone();
    let anchors: [Anchor<S>; 8] = anchors(&world, [STIFFNESS; 8]);
    let mut forces = (
        anchors,
        PerBody(|time: Time, _: &Point<S>| drive::<S>(amplitude, time)),
    );
    let (mut method, step) = (scheme.method(), Step::hz(rate).unwrap());
    let (omega, mut worst) = (STIFFNESS.sqrt(), [0.0; 16]);
    for tick in 1..=rate * SECONDS {
        world.step(&mut method, &mut forces, &step);
        for (i, (now, start)) in world.bodies().iter().zip(start.bodies()).enumerate() {
            let [exact, rate] = exact(start, amplitude, tick as f64 / rate as f64);
            let (x, v) = (
                now.position().to_f64().array(),
                now.velocity().to_f64().array(),
            );
            for axis in 0..2 {
                let error = &mut worst[2 * i + axis];
                let off = (x[axis] - exact[axis]).hypot(v[axis] / omega - rate[axis]);
                *error = maximum(&[*error, off]);
            }
        }
    }
    worst
}

/// Six standard deviations of rounding at `rate`, in m. A step is close to a rotation in (x, v/ω):
/// its roundings add up as they are, 1/12 of a unit² for each drift and each of two products of
/// a kick, of which PEFRL has four; Runge-Kutta has less, a sixth of each of its four and one more. Coefficients that are off by `COEFFICIENT` shift the phase by ω T times that.
fn floor<S: Format>(scheme: Scheme, rate: i32) -> f64 {
    let omega = STIFFNESS.sqrt();
    let (x, u) = (S::unit(26.0), S::unit(26.0 * omega) / omega);
    let steps = (rate * SECONDS) as f64;
    let products = if scheme == Scheme::Pefrl { 8.0 } else { 4.0 };
    let variance = steps / 12.0 * (scheme.drifts() * x * x + products * u * u);
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
fn check<S: Format>(scheme: Scheme, amplitude: f64, order: f64, rates: [i32; 8]) {
    let floors = rates.map(|rate| floor::<S>(scheme, rate));
    let table = rates.map(|rate| errors::<S>(scheme, amplitude, rate));
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
    check::<f32>(scheme, AMPLITUDE, order, rates);
    check::<f64>(scheme, AMPLITUDE, order, rates);
    check::<I16F16>(scheme, AMPLITUDE, order, rates);
    check::<I12F20>(scheme, AMPLITUDE, order, rates);
    check::<I8F24>(scheme, AMPLITUDE, order, rates);
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

#[test]
fn rk4_has_order_4() {
    check::<f32>(Scheme::Rk4, AMPLITUDE, 4.0, LEAST);
    check::<f64>(Scheme::Rk4, AMPLITUDE, 4.0, LEAST);
    check::<I16F16>(Scheme::Rk4, AMPLITUDE, 4.0, LEAST);
    check::<I12F20>(Scheme::Rk4, AMPLITUDE, 4.0, LEAST);
    check::<I8F24>(Scheme::Rk4, AMPLITUDE, 4.0, FITTING);
}

/// All four kicks take the drive from the middle of the step, which is off by 1e-3 of the swing at 5 Hz:
/// less than the other scalars need.
#[test]
fn pefrl_has_order_2_under_a_force_of_time() {
    check::<f64>(Scheme::Pefrl, AMPLITUDE, 2.0, COARSE);
    check::<I8F24>(Scheme::Pefrl, AMPLITUDE, 2.0, COARSE);
}

/// Its error, 6e-5 (ω h)^4 of the phase, is above the rounding of `f64` and `I8F24` only.
#[test]
fn pefrl_has_order_4_under_a_force_of_position() {
    check::<f64>(Scheme::Pefrl, 0.0, 4.0, LEAST);
    check::<I8F24>(Scheme::Pefrl, 0.0, 4.0, LEAST);
}
