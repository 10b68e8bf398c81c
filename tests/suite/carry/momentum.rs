//! Bodies on springs: what one gains the other loses, to the bit, for any masses. Momenta are compared
//! as exact integers.

use fixstep::fixed::types::{I8F24, I12F20, I16F16};
use fixstep::{Carried, Pairs, Point, Spring, Step, World};

use super::bits::{Fine, counted_mass, exact, momentum};
use crate::support::*;

const STEPS: u32 = long(1_000_000) as u32;
const SHORT: u32 = long(10_000) as u32;

const MASSES: [[f64; 2]; 3] = [[1.0, 3.0], [1.37, 2.91], [1.0, 1000.0]];

/// Velocities less that of the centre of mass, so that no run leaves the range.
fn at_rest<const N: usize>(mut velocities: [[f64; 2]; N], masses: [f64; N]) -> [[f64; 2]; N] {
    for axis in 0..2 {
        let momentum: f64 = (0..N).map(|i| masses[i] * velocities[i][axis]).sum();
        let centre = momentum / masses.iter().sum::<f64>();
        velocities.iter_mut().for_each(|v| v[axis] -= centre);
    }
    velocities
}

fn start<S: Format, const N: usize>(start: usize, masses: [f64; N]) -> [Point<S>; N] {
    let side = |i: usize| {
        let turn = angle(start) + std::f64::consts::TAU * i as f64 / N as f64;
        turn.sin_cos()
    };
    let speed = |i: usize| 0.3 + 0.4 * spread(start + i);
    let velocity = |i: usize| [-speed(i) * side(i).0, speed(i) * side(i).1];
    let velocities = at_rest(std::array::from_fn(velocity), masses);
    std::array::from_fn(|i| point([side(i).1, side(i).0], velocities[i], masses[i]))
}

/// Bodies of a ring, turning about its middle, on springs of which none is at rest.
fn ring<S: Fine, const N: usize>(i: usize, masses: [f64; N]) -> World<Carried<S>, N> {
    world(start::<S, N>(i, masses).map(Carried::from))
}

/// The sum of all momenta. Each is a whole number of units; so is their sum, and `f64` adds them
/// without rounding as long as the largest less the smallest unit is below 53 bits.
fn total<S: Fine, const N: usize>(world: &World<Carried<S>, N>) -> [i128; 2] {
    let sum = world.bodies().iter().map(momentum);
    let sum = sum.fold([0; 2], |a, b| [a[0] + b[0], a[1] + b[1]]);
    let floats = world.bodies().iter().map(Carried::momentum);
    let floats = floats.fold(fixstep::Vec2::ZERO, |a, b| a + b);
    assert_eq!(floats.array().map(exact), sum, "a sum of f64 was rounded");
    sum
}

/// Velocities are within one unit of what their momentum says.
fn check_velocities<S: Fine, const N: usize>(world: &World<Carried<S>, N>) {
    for body in world.bodies() {
        let said = body.momentum().array().map(|p| p / counted_mass(body));
        for (v, said) in body.velocity().to_f64().array().into_iter().zip(said) {
            assert!((v - said).abs() <= S::unit(0.0), "{v} {said}");
        }
    }
}

/// The momentum of a run is looked at every so many steps, and moves bodies.
fn check<S: Fine, const N: usize>(scheme: Scheme, start: usize, masses: [f64; N], steps: u32) {
    let mut world = ring::<S, N>(start, masses);
    let ids = world.ids().to_vec();
    let links: [_; N] = std::array::from_fn(|i| [ids[i], ids[(i + 1) % N]]);
    let spring = Spring::new(ratio(1.2), ratio(7.3), 0).unwrap();
    let mut spring = Pairs::new(spring, &links[..if N == 2 { 1 } else { N }]);
    let (mut method, step) = (scheme.method(), Step::hz(60).unwrap());
    let (before, mut moved) = (total(&world), 0);
    for tick in 0..steps {
        let velocity = world.bodies()[0].velocity();
        world.step(&mut method, &mut spring, &step);
        moved += u32::from(world.bodies()[0].velocity() != velocity);
        if tick % 101 == 0 || tick + 1 == steps {
            let what = format!("{} {scheme:?} {masses:?} tick {tick}", S::name());
            assert_eq!(total(&world), before, "{what}");
            check_velocities(&world);
        }
    }
    assert!(moved > steps / 2 && world.out_of_range().count() == 0);
}

fn check_pairs<S: Fine>(long: u32) {
    let schemes = [Scheme::SemiImplicitEuler, Scheme::Verlet];
    for masses in MASSES {
        check::<S, 2>(schemes[0], 0, masses, long);
        for start in 1..17 {
            check::<S, 2>(schemes[start % 2], start, masses, SHORT);
        }
    }
}

#[test]
fn two_bodies_keep_their_momentum_in_i16f16() {
    check_pairs::<I16F16>(STEPS);
}

#[test]
fn two_bodies_keep_their_momentum_in_i12f20() {
    check_pairs::<I12F20>(STEPS / 10);
}

#[test]
fn two_bodies_keep_their_momentum_in_i8f24() {
    check_pairs::<I8F24>(STEPS / 10);
}

#[test]
fn a_ring_of_six_masses_keeps_its_momentum() {
    let masses = [0.31, 1.0, 2.91, 7.3, 41.0, 0.77];
    for scheme in [Scheme::SemiImplicitEuler, Scheme::Verlet] {
        for start in 0..2 {
            check::<I16F16, 6>(scheme, start, masses, SHORT);
            check::<I12F20, 6>(scheme, start, masses, SHORT);
            check::<I8F24, 6>(scheme, start, masses, SHORT);
        }
    }
}

/// A point rounds each velocity: half a unit of its mass for each push, and as pushes are alike, for
/// long in one direction.
fn point_drifts<S: Format>(masses: [f64; 2]) {
    let errors: [f64; 16] = std::array::from_fn(|i| {
        let mut world: World<Point<S>, 2> = world(start(i, masses));
        let ids = [world.ids()[0], world.ids()[1]];
        let spring = Spring::new(ratio(1.2), ratio(7.3), 0).unwrap();
        let mut spring = Pairs::new(spring, [ids]);
        let (mut method, step) = (Scheme::Verlet.method(), Step::hz(60).unwrap());
        let before = world.momentum();
        for _ in 0..SHORT {
            world.step(&mut method, &mut spring, &step);
        }
        (world.momentum() - before).length()
    });
    let bound = SHORT as f64 * S::unit(1.0) * (masses[0] + masses[1]);
    let what = format!("{} Point {masses:?} 1e4 steps, kg m/s", S::name());
    within(bound, &what, &errors);
}

#[test]
fn points_drift() {
    for masses in MASSES {
        point_drifts::<f32>(masses);
        point_drifts::<I16F16>(masses);
        point_drifts::<I8F24>(masses);
    }
}
