//! A drag remembers its factor for a mass, a part and a step: any mixture gives the bits that a drag
//! made anew for each step and each body gives.

use super::RATE;
use crate::support::*;
use fixstep::fixed::types::I16F16;
use fixstep::{Ballistic, BodyId, Decay, ExactDrag, ExactQuadraticDrag, Force, Method, Point};
use fixstep::{SemiImplicitEuler, Step, TimeStep, Verlet, World};

/// Masses of neighbours: alternating, repeated, all different.
const MASSES: [[f64; 4]; 4] = [
    [1.0, 2.0, 1.0, 2.0],
    [2.0, 2.0, 1.0, 1.0],
    [0.3, 7.0, 0.3, 1.9],
    [4.0, 3.0, 2.0, 1.0],
];

/// Rates of the steps, in turn: the same twice, another, back.
const RATES: [i32; 5] = [RATE as i32, RATE as i32, 120, RATE as i32, 50];

/// Methods that take a flow: `Chosen` names all.
#[derive(Clone, Copy)]
enum Splitting {
    Semi,
    Verlet,
}

impl<S: Format> Method<Point<S>, 4> for Splitting {
    fn step<F: Force<Point<S>>, H: TimeStep<S>>(
        &mut self,
        ids: &[BodyId],
        bodies: &mut [Point<S>],
        forces: &mut F,
        step: &H,
        tick: u64,
    ) {
        match self {
            Splitting::Semi => {
                let method = &mut SemiImplicitEuler;
                Method::<_, 4>::step(method, ids, bodies, forces, step, tick);
            }
            Splitting::Verlet => Method::<_, 4>::step(&mut Verlet, ids, bodies, forces, step, tick),
        }
    }
}

fn of<S: Format>(bodies: &[Point<S>]) -> World<Point<S>, 4> {
    let mut world = World::new();
    for &body in bodies {
        world.add(body).unwrap();
    }
    world
}

/// All in one world with one force, against each alone with a new force in every step. The method
/// changes every second step, the length of the step in another rhythm.
fn check<S, F, M>(make: impl Fn() -> F, method: impl Fn(usize) -> M)
where
    S: Format + Decay,
    F: Force<Point<S>>,
    M: Method<Point<S>, 4>,
{
    for (w, masses) in MASSES.into_iter().enumerate() {
        let bodies: [_; 4] = std::array::from_fn(|i| {
            let [x, y] = [0, 1].map(|k| 40.0 * (spread(8 * w + 2 * i + k) - 0.5));
            point::<S>([0.0; 2], [x, y], masses[i])
        });
        let (mut together, mut alone) = (of(&bodies), bodies.map(|body| of(&[body])));
        let mut force = make();
        for n in 0..30 {
            let step = Step::hz(RATES[n % RATES.len()]).unwrap();
            together.step(&mut method(n / 2), &mut force, &step);
            for (i, world) in alone.iter_mut().enumerate() {
                world.step(&mut method(n / 2), &mut make(), &step);
                let (got, wanted) = (together.bodies()[i], world.bodies()[0]);
                assert_eq!(got, wanted, "{} {masses:?} {i} step {n}", S::name());
            }
        }
        let moved = |i: usize| together.bodies()[i].velocity() != bodies[i].velocity();
        assert!((0..4).all(moved));
    }
}

fn check_scalar<S: Format + Decay>() {
    let scheme = |n: usize| SCHEMES[n % 4].method::<Point<S>, 4>();
    check::<S, _, _>(|| ExactDrag::new(ratio(2.7)).unwrap(), scheme);
    check::<S, _, _>(|| ExactQuadraticDrag::new(ratio(0.3)).unwrap(), scheme);
    let splitting = |n: usize| [Splitting::Semi, Splitting::Verlet][n % 2];
    let flight = || Ballistic::new(vector(0.5, -9.81), ratio(2.7)).unwrap();
    check::<S, _, _>(flight, splitting);
}

#[test]
fn what_a_drag_remembers_changes_no_bit() {
    check_scalar::<f32>();
    check_scalar::<I16F16>();
}
