//! A spring solved exactly keeps its energy, `x² + u²` with u = v/ω, at any `ω h`.

use std::f64::consts::TAU;

use fixstep::fixed::types::{I8F24, I12F20, I16F16, I20F12};
use fixstep::{ExactSpring, Method, Point, SemiImplicitEuler, Step, Vec2, Verlet, World};

use crate::invariants::{RATE, room};
use crate::support::*;

const STEPS: u32 = long(100_000) as u32;
const QS: [f64; 4] = [0.1, 1.1, 2.5, 6.0];

/// Four phases, on a circle in (x, u), for each of `QS`.
fn q(axis: usize) -> f64 {
    QS[axis / 4]
}

fn size<S: Format>(axis: usize) -> f64 {
    room::<S>() / (q(axis) * RATE).max(1.0)
}

fn start<S: Format>(i: usize) -> Point<S> {
    let axis = |axis: usize| {
        let (sin, cos) = angle(axis).sin_cos();
        let size = size::<S>(axis);
        [size * cos, size * sin * q(axis) * RATE]
    };
    let [x, y] = [axis(2 * i), axis(2 * i + 1)];
    point([x[0], y[0]], [x[1], y[1]], 1.0)
}

fn energies<S: Format>(world: &World<Point<S>, 8>) -> [f64; 16] {
    std::array::from_fn(|axis| {
        let body = &world.bodies()[axis / 2];
        let (x, v) = (
            body.position().to_f64().array(),
            body.velocity().to_f64().array(),
        );
        let u = v[axis % 2] / (q(axis) * RATE);
        x[axis % 2] * x[axis % 2] + u * u
    })
}

/// The largest change of the energy in 100,000 steps, by what is allowed. A step has at most two flows
/// of three shears; each rounds once, in floats twice: twelve roundings of `1/12` unit² in x or u, of
/// which each changes the energy by at most `2 size` times itself, stretched by two as half a turn is
/// `1/cos² 45°`. Six standard deviations. The shears keep `x² + (2α/β - α²) v²`, which differs from the
/// energy by what α and β are off: `2α/β` is at most twice `1/ω²`, so six times `COEFFICIENT`.
fn check<S: Format, M: Method<Point<S>, 8>>(name: &str, mut method: M) {
    let mut world = world(std::array::from_fn(start::<S>));
    let spring = |i: usize| {
        let hertz = ratio(q(2 * i) * RATE / TAU);
        ExactSpring::new(world.ids()[i], Vec2::ZERO, hertz, 0).unwrap()
    };
    let mut springs: [_; 8] = std::array::from_fn(spring);
    let (step, before, mut largest) = (Step::hz(60).unwrap(), energies(&world), [0.0; 16]);
    for _ in 0..STEPS {
        world.step(&mut method, &mut springs, &step);
        for (i, now) in energies(&world).into_iter().enumerate() {
            largest[i] = maximum(&[largest[i], (now / before[i] - 1.0).abs()]);
        }
    }
    let parts: [f64; 16] = std::array::from_fn(|i| {
        let (size, omega) = (size::<S>(i), q(i) * RATE);
        let unit = S::unit(size).max(S::unit(size * omega) / omega);
        let walk = 6.0 * f64::from(STEPS).sqrt() * 2.0 * 2.0 * unit / size;
        largest[i] / (walk + 6.0 * S::COEFFICIENT)
    });
    within(
        1.0,
        &format!("{} {name} energy, of the allowance", S::name()),
        &parts,
    );
    within(
        1e-1,
        &format!("{} {name} energy, relative", S::name()),
        &largest,
    );
}

fn check_both<S: Format>() {
    check::<S, _>("SemiImplicitEuler", SemiImplicitEuler);
    check::<S, _>("Verlet", Verlet);
}

#[test]
fn an_exact_spring_keeps_its_energy() {
    check_both::<f32>();
    check_both::<f64>();
    check_both::<I16F16>();
    check_both::<I12F20>();
    check_both::<I8F24>();
    check_both::<I20F12>();
}
