//! Two springs of 1 Hz at 60 steps a second whose energy rises: by explicit Euler, and by a force that
//! is held over the substeps of a step.
//!
//! State (x, u) with u = v/ω, and q = ω H for a step H. Explicit Euler turns and stretches, `x' = x + q u, u'
//! = u - q x`: energy times `1 + q²`. Held over n substeps of `h = H/n`, each a semi-implicit one, the
//! acceleration a of the start moves
//!
//! ```text
//! v' = v + n h a                      u' = u - q x
//! x' = x + sum (h (v + j h a))        x' = x (1 - c q²) + q u,   c = (n + 1) / (2 n)
//! ```
//!
//! whose determinant is `g = 1 + q² (n - 1) / (2 n)`. As `x² + u² - c q x u` grows by g in a step, so does the
//! energy, but for a factor of `(1 + c q/2) / (1 - c q/2)` to either side: none for one substep.

use std::f64::consts::TAU;

use fixstep::fixed::types::I16F16;
use fixstep::{Anchor, Method, PerBody, Point, SemiImplicitEuler, Step, Time, Vec2, World};

use crate::support::*;

const RATE: u32 = 60;
/// ω H of 1 Hz.
pub const Q: f64 = TAU / RATE as f64;

/// Energy after a step by that before it, of a force held over n substeps.
pub fn held_growth(q: f64, n: u32) -> f64 {
    1.0 + q * q * f64::from(n - 1) / f64::from(2 * n)
}

/// The same by explicit Euler.
pub fn euler_growth(q: f64) -> f64 {
    1.0 + q * q
}

/// Steps in which an energy that grows so doubles.
pub fn doubling(growth: f64) -> f64 {
    2.0_f64.ln() / growth.ln()
}

/// A body of 1 kg at 1 m, at rest.
fn start<S: Format>() -> World<Point<S>, 1> {
    world([point([1.0, 0.0], [0.0; 2], 1.0)])
}

/// Energies of a spring of 1 Hz by that of the start, `[seconds, energy]`, each `every` steps.
fn energies<S: Format>(
    mut world: World<Point<S>, 1>,
    mut step: impl FnMut(&mut World<Point<S>, 1>),
    steps: u32,
    every: u32,
) -> Vec<[f64; 2]> {
    let energy = |body: &Point<S>| {
        let (x, v) = (body.position().to_f64().x, body.velocity().to_f64().x);
        x * x + (v / TAU).powi(2)
    };
    let mut found = vec![[0.0, energy(&world.bodies()[0])]];
    for n in 1..=steps {
        step(&mut world);
        if n.is_multiple_of(every) {
            let seconds = f64::from(n) / f64::from(RATE);
            found.push([seconds, energy(&world.bodies()[0])]);
        }
    }
    found
}

/// A spring by one of the crate's methods, in `I16F16`.
pub fn by<M: Method<Point<I16F16>, 1>>(mut method: M, steps: u32, every: u32) -> Vec<[f64; 2]> {
    let world = start();
    let mut spring: [Anchor<I16F16>; 1] = anchors(&world, [TAU * TAU]);
    let step = Step::hz(ratio(f64::from(RATE))).unwrap();
    energies(
        world,
        |world| world.step(&mut method, &mut spring, &step),
        steps,
        every,
    )
}

/// A step of a spring of 1 Hz whose force is worked out once and held over `n` substeps.
pub fn held_step<const N: usize>(n: u32) -> impl FnMut(&mut World<Point<f64>, N>) {
    let substep = Step::hz(ratio(f64::from(RATE * n))).unwrap();
    let mut pull = Vec2::ZERO;
    let mut force = PerBody(move |time: Time, body: &Point<f64>| -> Vec2<f64> {
        if (time.half_ticks() / 2).is_multiple_of(u64::from(n)) {
            pull = body.position().map(|x| -TAU * TAU * x);
        }
        pull
    });
    move |world| {
        for _ in 0..n {
            world.step(&mut SemiImplicitEuler, &mut force, &substep);
        }
    }
}

/// A spring that is held, in `f64`.
pub fn held(n: u32, steps: u32, every: u32) -> Vec<[f64; 2]> {
    energies(start(), held_step(n), steps, every)
}
