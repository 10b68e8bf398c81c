//! Two bodies on a spring: each impulse is taken from one as it is given to the other, so the
//! total momentum changes by the rounding of velocities alone.

use crate::support;

use fixstep::fixed::types::{I8F24, I12F20, I16F16};
use fixstep::{Body, BodyId, Pairs, Point, Scalar, Spring, Step, TimeStep, Vec2, World};
use support::*;

const STEPS: u32 = long(100_000) as u32;

/// A point that remembers its last push and counts pushes and kicks.
#[derive(Clone, Copy, Debug)]
struct Probe<S: Scalar> {
    point: Point<S>,
    last: Vec2<S>,
    pushes: u32,
    kicks: u32,
}

impl<S: Scalar> Body for Probe<S> {
    type S = S;
    type Spin = fixstep::body::NoSpin;

    fn position(&self) -> Vec2<S> {
        self.point.position()
    }

    fn velocity(&self) -> Vec2<S> {
        self.point.velocity()
    }

    fn inv_mass(&self) -> S::InvMass {
        self.point.inv_mass()
    }

    fn kick(&mut self, dv: Vec2<S>) {
        self.kicks += 1;
        self.point.kick(dv);
    }

    fn push(&mut self, impulse: Vec2<S>) {
        self.pushes += 1;
        self.last = impulse;
        self.point.push(impulse);
    }

    fn shift(&mut self, dx: Vec2<S>) {
        self.point.shift(dx);
    }

    fn drift(&mut self, step: &impl TimeStep<S>) {
        self.point.drift(step);
    }

    fn drift_half(&mut self, step: &impl TimeStep<S>) {
        self.point.drift_half(step);
    }
}

/// Pair `i`: turned by its own angle, stretched, turning about itself, its centre at rest.
fn pair<S: Format>(i: usize, masses: [f64; 2]) -> World<Probe<S>, 2> {
    let (sin, cos) = angle(i).sin_cos();
    let share = masses[0] / (masses[0] + masses[1]);
    let body = |mass, along: f64| {
        let speed = 0.8 * along;
        let point = point(
            [along * cos, along * sin],
            [-speed * sin, speed * cos],
            mass,
        );
        Probe {
            point,
            last: Vec2::ZERO,
            pushes: 0,
            kicks: 0,
        }
    };
    world([
        body(masses[0], 3.0 * (share - 1.0)),
        body(masses[1], 3.0 * share),
    ])
}

/// A spring that oscillates at about 5 rad/s whatever the masses, and keeps swinging for the run.
fn spring<S: Format>(
    world: &World<Probe<S>, 2>,
    masses: [f64; 2],
) -> Pairs<Spring<S>, [[BodyId; 2]; 1]> {
    let reduced = masses[0] * masses[1] / (masses[0] + masses[1]);
    let ids = [world.ids()[0], world.ids()[1]];
    Pairs::new(
        Spring::new(ratio(1.7), ratio(25.0 * reduced), ratio(1e-5 * reduced)).unwrap(),
        [ids],
    )
}

/// Runs a pair: the impulses of each step must sum to zero to the bit, and nothing else may act.
/// Gives the largest change of momentum in units of `unit`.
fn run<S: Format>(scheme: Scheme, masses: [f64; 2], i: usize) -> f64 {
    let mut world = pair::<S>(i, masses);
    let mut spring = spring(&world, masses);
    let (mut method, step) = (scheme.method(), Step::hz(60).unwrap());
    let start = world.momentum();
    let (mut drift, mut speeds, mut acting) = (0.0_f64, [0.0_f64; 2], 0);
    for tick in 1..=STEPS {
        world.step(&mut method, &mut spring, &step);
        let [a, b] = [0, 1].map(|i| &world.bodies()[i]);
        assert!(
            a.last == -b.last,
            "{} {scheme:?} {masses:?} kg, tick {tick}",
            S::name()
        );
        assert_eq!([a.pushes, b.pushes, a.kicks, b.kicks], [tick, tick, 0, 0]);
        acting += (a.last != Vec2::ZERO) as u32;
        if tick.is_multiple_of(32) {
            let change = world.momentum() - start;
            drift = maximum(&[drift, change.x.abs(), change.y.abs()]);
            speeds = [0, 1].map(|i| maximum(&[speeds[i], speed(&world.bodies()[i])]));
        }
    }
    assert!(
        acting > STEPS / 2,
        "{} {scheme:?} {masses:?} kg: at rest",
        S::name()
    );
    drift / unit::<S>(masses, speeds)
}

/// The larger part of a velocity.
fn speed<S: Format>(probe: &Probe<S>) -> f64 {
    let v = probe.velocity().to_f64();
    v.x.abs().max(v.y.abs())
}

/// sqrt(sum(M²)) units of velocity, each at the largest speed of its body.
fn unit<S: Format>(masses: [f64; 2], speeds: [f64; 2]) -> f64 {
    (masses[0] * S::unit(speeds[0])).hypot(masses[1] * S::unit(speeds[1]))
}

/// A push rounds each velocity once, which changes the momentum by the mass times an error of
/// variance 1/12 of a unit²; N pushes, five standard deviations: 5 units sqrt(N sum(M²) / 12).
fn check<S: Format>(masses: [f64; 2]) {
    let bound = 5.0 * (STEPS as f64 / 12.0).sqrt();
    for scheme in [Scheme::SemiImplicitEuler, Scheme::Verlet] {
        let drifts: [f64; 16] = std::array::from_fn(|i| run::<S>(scheme, masses, i));
        within(
            bound,
            &format!("{} {scheme:?} {masses:?} kg, units", S::name()),
            &drifts,
        );
    }
}

fn check_masses<S: Format>() {
    check::<S>([1.0, 3.0]);
    check::<S>([1.37, 2.91]);
    check::<S>([1.0, 1000.0]);
}

#[test]
fn momentum_of_a_pair_stays_in_f32() {
    check_masses::<f32>();
}

#[test]
fn momentum_of_a_pair_stays_in_f64() {
    check_masses::<f64>();
}

#[test]
fn momentum_of_a_pair_stays_in_i16f16() {
    check_masses::<I16F16>();
}

#[test]
fn momentum_of_a_pair_stays_in_i12f20() {
    check_masses::<I12F20>();
}

#[test]
fn momentum_of_a_pair_stays_in_i8f24() {
    check_masses::<I8F24>();
}
