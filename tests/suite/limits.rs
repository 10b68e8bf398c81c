//! Where each method stops being stable: bounded below its limit and growing above, for a spring and for drag. The lab has the
//! whole maps.

use fixstep::fixed::types::I16F16;
use fixstep::{ExactDrag, LinearDrag, Step, World};

use crate::support::*;

const STEPS: u32 = 2000;
const RATE: f64 = 64.0;

/// The largest `|x|` of a spring with `h ω = q` that starts at `size`, at rest, after which no step is made once it is
/// fifty times as far.
fn reached<S: Format>(scheme: Scheme, q: f64, size: f64) -> f64 {
    let mut world: World<_, 1> = world([point::<S>([size, 0.0], [0.0; 2], 1.0)]);
    let omega = q * RATE;
    let mut springs = anchors(&world, [omega * omega]);
    let (mut method, step) = (scheme.method(), Step::hz(ratio(RATE)).unwrap());
    let mut most = 0.0_f64;
    for _ in 0..STEPS {
        world.step(&mut method, &mut springs, &step);
        most = maximum(&[most, world.bodies()[0].position().x.to_f64().abs()]);
        if most > 50.0 * size {
            break;
        }
    }
    most
}

/// Below `h ω = 2` both methods keep `x² + u² - q x u` or its half-step image, so that no swing from rest is longer than
/// `1 / sqrt(1 - q²/4)` times its start; a part of 1e-2 is left for rounding. Above, the larger root of the step has the
/// magnitude `q²/2 - 1 + sqrt((q²/2 - 1)² - 1)`, 1.32 at 2.04: fifty times in 15 steps. Runge-Kutta has `2 sqrt(2)`,
/// below which it shrinks.
fn spring<S: Format>() {
    for (scheme, limit) in [
        (Scheme::SemiImplicitEuler, 2.0),
        (Scheme::Verlet, 2.0),
        (Scheme::Rk4, 8.0_f64.sqrt()),
    ] {
        for part in [0.5, 0.9, 0.98] {
            let q: f64 = part * limit;
            let stretch = match scheme {
                Scheme::Rk4 => 2.0,
                _ => 1.0 / (1.0 - q * q / 4.0).sqrt(),
            };
            let (most, bound) = (reached::<S>(scheme, q, 0.25), 0.25 * stretch * 1.01);
            assert!(
                most <= bound,
                "{} {scheme:?} q {q}: {most} > {bound}",
                S::name()
            );
        }
        let most = reached::<S>(scheme, 1.02 * limit, 0.25);
        assert!(most >= 12.5, "{} {scheme:?} above: {most}", S::name());
    }
    // Euler's method gains `sqrt(1 + q²)` a step at every rate: fifty times in 400 steps at q = 0.14.
    let most = reached::<S>(Scheme::Euler, 0.14, 0.25);
    assert!(most >= 12.5, "{} Euler: {most}", S::name());
}

#[test]
fn springs_are_bounded_below_their_limit_and_grow_above() {
    spring::<f64>();
    spring::<f32>();
    spring::<I16F16>();
}

/// What is left of a speed of 4 m/s after so many steps of drag with `k h / m = x`.
fn left<S: Format + fixstep::Decay>(scheme: Scheme, x: f64, steps: u32, exact: bool) -> f64 {
    let mut world: World<_, 1> = world([point::<S>([0.0; 2], [4.0, 0.0], 1.0)]);
    let (mut method, step) = (scheme.method(), Step::hz(ratio(RATE)).unwrap());
    let (mut drag, mut exactly) = (
        LinearDrag::new(ratio(x * RATE)).unwrap(),
        ExactDrag::new(ratio(x * RATE)).unwrap(),
    );
    for _ in 0..steps {
        match exact {
            true => world.step(&mut method, &mut exactly, &step),
            false => world.step(&mut method, &mut drag, &step),
        }
    }
    world.bodies()[0].velocity().x.to_f64()
}

/// One call a step multiplies the velocity by `1 - x`: it changes sign above 1 and grows above 2. An exact factor does neither.
#[test]
fn explicit_drag_has_a_limit_and_exact_drag_has_none() {
    fn check<S: Format + fixstep::Decay>() {
        for scheme in SCHEMES {
            let (one, slow) = (
                left::<S>(scheme, 1.5, 1, false),
                left::<S>(scheme, 1.9, 60, false),
            );
            assert!(
                (one + 2.0).abs() <= 8.0 * S::unit(4.0),
                "{} {scheme:?}: {one}",
                S::name()
            );
            assert!(
                slow.abs() <= 4.0 * 0.9_f64.powi(60) + 60.0 * S::unit(4.0),
                "{} {scheme:?}: {slow}",
                S::name()
            );
            let grown = left::<S>(scheme, 2.1, 60, false);
            assert!(grown.abs() >= 400.0, "{} {scheme:?}: {grown}", S::name());
            for x in [0.5_f64, 2.1, 20.0] {
                let exact = 4.0 * (-x).exp();
                let found = left::<S>(scheme, x, 1, true);
                assert!(
                    (found - exact).abs() <= 4.0 * S::unit(4.0),
                    "{} {scheme:?} {x}: {found}",
                    S::name()
                );
            }
        }
    }
    check::<f64>();
    check::<f32>();
    check::<I16F16>();
}
