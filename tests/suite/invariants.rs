//! What each method keeps of a motion, and by what law it loses the rest.
//!
//! Angular momentum `L = x × v` under a force along x, `v' = v + f x` and `x' = x + h v'`: as `x × x`
//! and `v' × v'` vanish, L' = L. Drifts and kicks each keep it, in any order. Where both start from one
//! state they do not:
//!
//! ```text
//! Euler                  (x + h v) × (v + f x)                 = L (1 - h f)
//! ConstantAcceleration   (x + h v + h/2 f x) × (v + f x)       = L (1 - h f / 2)
//! ```
//!
//! with `f = -h ω²` for a spring: L grows by 1 + q² or 1 + q²/2 a step. Energy is kept by a spring that
//! is solved exactly, the kept forms of the other methods are those of `oscillator.rs`.

#[path = "invariants/energy.rs"]
mod energy;
#[path = "invariants/pair.rs"]
mod pair;
use crate::support;

use fixstep::fixed::types::{I8F24, I12F20, I16F16, I20F12};
use fixstep::{Point, Scalar, Step, World};
use support::*;

const RATE: f64 = 60.0;

/// Up to where bodies may go: half of the range, in floats 1000 m.
fn room<S: Scalar>() -> f64 {
    (0.5 * S::MAX.to_f64()).min(1000.0)
}

/// Sixteen bodies around the origin, none on a circle: 0.6 of its speed, and a quarter of that along x.
fn orbits<S: Format>(size: f64, omega: f64) -> World<Point<S>, 16> {
    let body = |i: usize| {
        let (sin, cos) = angle(i).sin_cos();
        let (along, across) = (0.15 * omega * size, 0.6 * omega * size);
        let velocity = [along * cos - across * sin, along * sin + across * cos];
        point([size * cos, size * sin], velocity, 1.0)
    };
    world(std::array::from_fn(body))
}

fn momenta<S: Format>(world: &World<Point<S>, 16>) -> [f64; 16] {
    std::array::from_fn(|i| {
        let body = &world.bodies()[i];
        let (x, v) = (body.position().to_f64(), body.velocity().to_f64());
        x.x * v.y - x.y * v.x
    })
}

/// What rounding may change of L in `steps`: an error δ of v changes it by `x × δ`, one of x by `δ ×
/// v`, so that a rounding of both axes has the variance `x²/12` and `v²/12` of a unit². A kick has one,
/// in floats two; the half drifts of a step multiply one velocity and round alike. Six standard
/// deviations.
fn rounding<S: Format>(scheme: Scheme, size: f64, speed: f64, steps: f64) -> f64 {
    let kick = size * S::unit(speed);
    let drift = scheme.drifts() * speed * S::unit(size);
    6.0 * (steps / 12.0 * 2.0 * (kick * kick + drift * drift)).sqrt()
}

/// 100,000 steps on springs of q = 0.3, in which size and speed stay below 1.3 times their start: the
/// energy of the start is `1 + 0.6² + 0.15² = 1.38` times that of x alone, and the kept forms differ
/// from it by less than q/2 = 0.15 of itself.
fn check_kept<S: Format>(scheme: Scheme) {
    const STEPS: u32 = long(100_000) as u32;
    let omega = 0.3 * RATE;
    let size = room::<S>() / (1.3 * omega);
    let mut world = orbits::<S>(size, omega);
    let mut forces = anchors(&world, [omega * omega; 16]);
    let (mut method, step) = (scheme.method(), Step::hz(60).unwrap());
    let before = momenta(&world);
    for _ in 0..STEPS {
        world.step(&mut method, &mut forces, &step);
    }
    let after = momenta(&world);
    let errors: [f64; 16] = std::array::from_fn(|i| (after[i] - before[i]).abs());
    let bound = rounding::<S>(scheme, 1.3 * size, 1.3 * size * omega, f64::from(STEPS));
    assert!(bound <= 5e-2 * before[0], "a bound that bounds: {bound}");
    within(
        bound,
        &format!("{} {scheme:?} angular momentum", S::name()),
        &errors,
    );
}

/// Three e-foldings of L at q = 0.05, and so one and a half of size and speed. Rounding counts most at
/// the start, as all of it grows with the motion; h and `h ω²` are off by `COEFFICIENT`.
fn check_growth<S: Format>(scheme: Scheme) {
    let (q, omega) = (0.05_f64, 0.05 * RATE);
    let square = match scheme {
        Scheme::Euler => q * q,
        _ => q * q / 2.0,
    };
    let steps = (3.0 / square.ln_1p()).round();
    let size = room::<S>() / (5.0 * 1.3 * omega);
    let mut world = orbits::<S>(size, omega);
    let mut forces = anchors(&world, [omega * omega; 16]);
    let (mut method, step) = (scheme.method(), Step::hz(60).unwrap());
    let before = momenta(&world);
    for _ in 0..steps as u32 {
        world.step(&mut method, &mut forces, &step);
    }
    let (after, exact) = (momenta(&world), steps * square.ln_1p());
    let off = |i: usize| ((after[i] / before[i]).ln() - exact).abs();
    let errors: [f64; 16] = std::array::from_fn(off);
    let noise = rounding::<S>(scheme, 1.3 * size, 1.3 * size * omega, steps) / before[0];
    let bound = noise + 2.0 * S::COEFFICIENT * steps * square;
    within(
        bound,
        &format!("{} {scheme:?} growth of it", S::name()),
        &errors,
    );
}

fn check<S: Format>() {
    check_kept::<S>(Scheme::SemiImplicitEuler);
    check_kept::<S>(Scheme::Verlet);
    check_growth::<S>(Scheme::Euler);
    check_growth::<S>(Scheme::ConstantAcceleration);
}

#[test]
fn angular_momentum_about_an_anchor() {
    check::<f32>();
    check::<f64>();
    check::<I16F16>();
    check::<I12F20>();
    check::<I8F24>();
    check::<I20F12>();
}
