//! Position and velocity in every step of a run against the exact solution, with an impulse on the
//! way.

use std::f64::consts::TAU;

use fixstep::fixed::types::{I8F24, I12F20, I16F16, I20F12};
use fixstep::{Body, DyadicStep, ExactSpring, Factor, Point, Ratio, Step, TimeStep, Vec2, dec};

use crate::exact_spring::flow::{Double, step_of};
use crate::exact_spring::rounding::{Carried, of_flow};
use crate::exact_spring::splitting::{SPLITTINGS, Splitting};
use crate::support::*;

const STEPS: u32 = 120;
/// An impulse comes before this one.
const IMPULSE: u32 = 57;

/// A number in `low..high` that looks random.
fn within_range(random: &mut Random, [low, high]: [f64; 2]) -> f64 {
    low + (high - low) * (random.next() >> 11) as f64 / (1_u64 << 53) as f64
}

/// A swing of up to `amplitude` on each axis, and the impulse that sends it on.
struct Case {
    hertz: Ratio,
    omega: f64,
    amplitude: f64,
    rest: [f64; 2],
    phases: [f64; 2],
    impulse: [f64; 2],
    mass: f64,
}

/// Start `i`: 0.3 to 28 Hz, with velocities up to 40 m/s, which an `I8F24` has room for.
fn case(i: usize) -> Case {
    let mut random = Random(i as u64);
    let mut any = |range| within_range(&mut random, range);
    let hertz = ratio(0.3 * any([0.0, 94.0_f64.ln()]).exp());
    let omega = TAU * hertz.to_f64();
    let amplitude = (40.0 / omega).min(1.0) * any([0.3, 1.0]);
    let mass = any([0.5, 4.0]);
    let push = 0.5 * mass * omega * amplitude;
    Case {
        hertz,
        omega,
        amplitude,
        rest: [any([-2.0, 2.0]), any([-2.0, 2.0])],
        phases: [any([0.0, TAU]), any([0.0, TAU])],
        impulse: [any([-push, push]), any([-push, push])],
        mass,
    }
}

/// Displacement and velocity over ω of both axes.
fn phases<S: Format>(body: &Point<S>, rest: Vec2<S>, omega: Double) -> [[Double; 2]; 2] {
    let [x, v, rest] = [body.position(), body.velocity(), rest].map(|v| v.to_f64().array());
    std::array::from_fn(|k| {
        let z = Double::of(x[k]) - Double::of(rest[k]);
        [z, Double::of(v[k]) / omega]
    })
}

/// The largest error of a run, as part of what is allowed by then.
fn run<S: Format>(mut scheme: Splitting, zeta: Ratio, step: &impl TimeStep<S>, i: usize) -> f64 {
    let case = case(i);
    let (a, [p, q]) = (case.amplitude, case.phases);
    let rest = vector::<S>(case.rest[0], case.rest[1]);
    let place = |phase: f64, rest: f64| rest + a * phase.cos();
    let speed = |phase: f64| case.omega * a * phase.sin();
    let body = point(
        [place(p, case.rest[0]), place(q, case.rest[1])],
        [speed(p), speed(q)],
        case.mass,
    );
    let mut world = world([body]);
    let id = world.ids()[0];
    let mut spring = ExactSpring::new(id, rest, case.hertz, zeta).unwrap();
    let (omega, flow) = step_of(case.hertz, zeta, step.seconds());
    let mut exact = phases(&body, rest, omega);
    // Half as much again after the impulse.
    let each = scheme.flows() * of_flow::<S>(case.omega, 1.5 * a, 2.0);
    let (mut carried, mut extra, mut worst) = (Carried::new(flow), 0.0, 0.0_f64);
    for k in 0..STEPS {
        if k == IMPULSE {
            let impulse = vector(case.impulse[0], case.impulse[1]);
            world.get_mut(id).unwrap().push(impulse);
            let (impulse, inverse) = (impulse.to_f64().array(), body.inv_mass().to_f64());
            for (axis, impulse) in exact.iter_mut().zip(impulse) {
                let dv = Double::of(impulse) * Double::of(inverse);
                axis[1] = axis[1] + dv / omega;
            }
            // The product and the sum.
            extra = S::unit(1.5 * a * case.omega) / case.omega;
        }
        world.step(&mut scheme, &mut spring, step);
        carried.step();
        exact = exact.map(|axis| flow.of(axis));
        let allowed = carried.sum * each + extra;
        let now = phases(&world.bodies()[0], rest, omega);
        for (now, exact) in now.into_iter().zip(exact) {
            let off = |k: usize| (now[k] - exact[k]).to_f64();
            worst = maximum(&[worst, off(0).hypot(off(1)) / allowed]);
        }
    }
    worst
}

fn check<S: Format>() {
    let step = Step::<S>::hz(60).unwrap();
    let dyadic = DyadicStep::<S, 1, 6>::new().unwrap();
    for scheme in SPLITTINGS {
        for zeta in [dec!(0), dec!(0.07), dec!(0.5), dec!(1), dec!(2.3)] {
            let errors: [f64; 32] = std::array::from_fn(|i| match i % 2 {
                0 => run::<S>(scheme, zeta, &step, i / 2),
                _ => run::<S>(scheme, zeta, &dyadic, i / 2),
            });
            let (name, zeta) = (S::name(), zeta.to_f64());
            let what = format!("{name} {scheme:?} ζ = {zeta:.2}, of the allowance");
            within(1.0, &what, &errors);
        }
    }
}

#[test]
fn floats_follow_the_exact_solution() {
    check::<f64>();
    check::<f32>();
}

#[test]
fn fixed_point_follows_the_exact_solution() {
    check::<I16F16>();
    check::<I12F20>();
    check::<I8F24>();
    check::<I20F12>();
}
