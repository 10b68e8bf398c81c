//! A spring solved exactly is stable everywhere: the same map without a limit.
//!
//! A step is the flow through h in one piece or two, whose trace and determinant are
//!
//! ```text
//! trace  2 exp(-ζ q) cos(q sqrt(1 - ζ²))    above ζ = 1  exp(-q (ζ - r)) + exp(-q (ζ + r)), r = sqrt(ζ² - 1)
//! det    exp(-2 ζ q)
//! ```
//!
//! As `x² + u²` never rises in the exact motion, no swing is stretched.

use std::f64::consts::TAU;

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{ExactSpring, Method, Point, SemiImplicitEuler, Vec2, Verlet, World};

use crate::stability::law::Drag;
use crate::stability::map::ZETAS;
use crate::stability::run::columns;
use crate::stability::scene::*;
use crate::support::*;

const STEPS: u32 = 10_000;

fn closed(q: f64, zeta: f64) -> [f64; 2] {
    let r = (zeta * zeta - 1.0).abs().sqrt();
    let trace = match zeta <= 1.0 {
        true => 2.0 * (-zeta * q).exp() * (q * r).cos(),
        false => (-q * (zeta - r)).exp() + (-q * (zeta + r)).exp(),
    };
    [trace, (-2.0 * zeta * q).exp()]
}

/// Eight bodies in their springs: sixteen phases on a circle in (x, u).
struct Scene<S: Number> {
    world: World<Point<S>, 8>,
    springs: [ExactSpring<S>; 8],
    omega: f64,
}

impl<S: Number> Scene<S> {
    fn new(q: f64, zeta: f64, size: f64) -> Self {
        let swing = Swing {
            drag: Drag::Exact,
            q,
            zeta,
        };
        let (world, omega) = (swing.world(starts(size, None)), swing.omega());
        let hertz = ratio(omega / TAU);
        let spring = |i: usize| ExactSpring::new(world.ids()[i], Vec2::ZERO, hertz, ratio(zeta));
        let springs = std::array::from_fn(|i| spring(i).unwrap());
        Scene {
            world,
            springs,
            omega,
        }
    }

    fn step<M: Method<Point<S>, 8>>(&mut self, method: &mut M) {
        self.world.step(method, &mut self.springs, &step());
    }

    /// (x, u) of all axes.
    fn phases(&self) -> [[f64; 2]; 16] {
        std::array::from_fn(|i| {
            let (x, v) = state(&self.world.bodies()[i / 2]);
            [x[i % 2], v[i % 2] / self.omega]
        })
    }
}

/// The step in `f64` from what becomes of two phases: numbers of 60 bits, each of at most ten squarings
/// costs one, and the phases are far enough apart: 1e-13.
fn check_matrix<M: Method<Point<f64>, 8>>(method: &mut M, q: f64, zeta: f64) {
    let mut scene = Scene::<f64>::new(q, zeta, 1.0);
    let [a, b, ..] = scene.phases();
    scene.step(method);
    let [c, d, ..] = scene.phases();
    let cross = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] - a[1] * b[0];
    let area = cross(a, b);
    // M a = c and M b = d: det M = c×d / a×b, trace M = (c×b + a×d) / a×b.
    let measured = [(cross(c, b) + cross(a, d)) / area, cross(c, d) / area];
    let closed = closed(q, zeta);
    let errors = [0, 1].map(|i| (measured[i] - closed[i]).abs());
    assert!(
        errors.iter().all(|&error| error <= 1e-13),
        "q {q} zeta {zeta}: {errors:?}"
    );
}

/// The largest size of a run by that of its start, and whether it ever was at the end of the range.
/// Ends early where all have shrunk a thousandfold.
fn run<S: Number, M: Method<Point<S>, 8>>(method: &mut M, q: f64, zeta: f64) -> f64 {
    let size = reach::<S>() / (4.0 * (q * RATE).max(1.0));
    let (mut scene, mut largest) = (Scene::<S>::new(q, zeta, size), 0.0);
    for _ in 0..STEPS {
        scene.step(method);
        assert_eq!(
            scene.world.out_of_range().count(),
            0,
            "{} q {q} zeta {zeta}",
            S::name()
        );
        let now = maximum(&scene.phases().map(|[x, u]| x.hypot(u)));
        largest = maximum(&[largest, now]);
        if now <= 1e-3 * size {
            break;
        }
    }
    largest / size - 1.0
}

/// Every cell. Rounding may add six deviations of 16 roundings a step, 700 units; a start has 1.4e6 of
/// them at least, and a float as many digits: 1e-3.
fn check<S: Number>() {
    for (name, verlet) in [("SemiImplicitEuler", false), ("Verlet", true)] {
        let cells = columns().flat_map(|q| ZETAS.map(|zeta| (q, zeta)));
        let grown: Vec<f64> = cells
            .map(|(q, zeta)| match verlet {
                true => run::<S, _>(&mut Verlet, q, zeta),
                false => run::<S, _>(&mut SemiImplicitEuler, q, zeta),
            })
            .collect();
        within(
            1e-3,
            &format!("{} {name} exact spring, stretch", S::name()),
            &grown,
        );
    }
}

#[test]
fn an_exact_spring_has_no_limit_in_floats() {
    for (q, zeta) in columns().flat_map(|q| ZETAS.map(|zeta| (q, zeta))) {
        check_matrix(&mut SemiImplicitEuler, q, zeta);
        check_matrix(&mut Verlet, q, zeta);
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn an_exact_spring_has_no_limit_in_fixed_point() {
    check::<I16F16>();
    check::<I8F24>();
}
