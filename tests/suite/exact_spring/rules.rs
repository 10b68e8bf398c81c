//! Who moves a body when more than one would, and what happens when one is gone.

use fixstep::fixed::types::I16F16;
use fixstep::{BodyId, ExactPair, ExactSpring, Force, Point, Ratio, Step, Window, World, dec};

use crate::exact_spring::splitting::{SPLITTINGS, Splitting};
use crate::support::*;

type Scene = World<Point<I16F16>, 2>;

fn scene() -> Scene {
    world([
        point([1.5, 0.25], [0.5, -2.0], 1.37),
        point([-2.0, 1.0], [0.0, 1.5], 2.91),
    ])
}

fn ids() -> [BodyId; 2] {
    let world = scene();
    [world.ids()[0], world.ids()[1]]
}

fn spring(body: usize, hertz: Ratio) -> ExactSpring<I16F16> {
    ExactSpring::new(ids()[body], vector(0.5, 0.5), hertz, dec!(0.1)).unwrap()
}

fn pair(bodies: [BodyId; 2]) -> ExactPair<I16F16> {
    ExactPair::new(bodies, vector(1.0, 0.0), dec!(3), dec!(0.1)).unwrap()
}

/// The bodies after a second under `forces`.
fn after<F: Force<Point<I16F16>>>(
    mut scheme: Splitting,
    mut world: Scene,
    mut forces: F,
) -> Vec<Point<I16F16>> {
    let step = Step::hz(60).unwrap();
    for _ in 0..60 {
        world.step(&mut scheme, &mut forces, &step);
    }
    world.bodies().to_vec()
}

#[test]
fn of_two_springs_on_a_body_the_first_acts() {
    for scheme in SPLITTINGS {
        let run = |forces: [ExactSpring<I16F16>; 2]| after(scheme, scene(), forces);
        let alone = |force| after(scheme, scene(), force);
        let (slow, fast) = (spring(0, dec!(2)), spring(0, dec!(7)));
        assert_eq!(run([slow, fast]), alone(slow));
        assert_eq!(run([fast, slow]), alone(fast));
        assert_ne!(alone(slow), alone(fast));
    }
}

/// A second spring on a body does not even take back the kick of gravity.
#[test]
fn a_spring_that_does_not_act_takes_nothing_back() {
    for scheme in SPLITTINGS {
        let first = spring(0, dec!(2));
        let second = spring(0, dec!(7)).with_gravity(vector(0.0, -9.81)).unwrap();
        assert_eq!(
            after(scheme, scene(), (first, second)),
            after(scheme, scene(), first)
        );
    }
}

#[test]
fn of_a_spring_and_a_pair_the_first_acts() {
    for scheme in SPLITTINGS {
        let (one, both) = (spring(0, dec!(2)), pair(ids()));
        let run = |first| match first {
            "pair" => after(scheme, scene(), (both, one)),
            _ => after(scheme, scene(), (one, both)),
        };
        assert_eq!(run("pair"), after(scheme, scene(), both));
        assert_eq!(run("spring"), after(scheme, scene(), one));
    }
}

/// Bodies that no flow has drift as they do without one.
#[test]
fn a_pair_of_one_body_or_of_one_that_is_gone_leaves_it_alone() {
    for scheme in SPLITTINGS {
        let [a, b] = ids();
        let free = after(scheme, scene(), ());
        for twice in [[a, a], [b, b]] {
            assert_eq!(after(scheme, scene(), pair(twice)), free);
        }
        for (gone, stays) in [(a, 1), (b, 0)] {
            let mut world = scene();
            world.remove(gone).unwrap();
            assert_eq!(after(scheme, world, pair([a, b])), [free[stays]]);
        }
    }
}

/// A spring lets go where its body is removed in mid-run, and the other body does not feel it.
#[test]
fn a_spring_whose_body_is_gone_waits() {
    for scheme in SPLITTINGS {
        let mut world = scene();
        world.remove(ids()[0]).unwrap();
        let free = after(scheme, world.clone(), ());
        assert_eq!(after(scheme, world, spring(0, dec!(2))), free);
    }
}

#[test]
fn a_closed_window_leaves_the_drift() {
    for scheme in SPLITTINGS {
        let never = Window::new(0..0, spring(0, dec!(2)));
        assert_eq!(after(scheme, scene(), never), after(scheme, scene(), ()));
    }
}

/// What is kept for a step follows the step and the method: springs that were used with others do as new
/// ones do.
#[test]
fn a_spring_follows_a_change_of_step_and_method() {
    let of = |forces: (ExactSpring<I16F16>, ExactPair<I16F16>), scheme| {
        [
            after(scheme, scene(), forces.0),
            after(scheme, scene(), forces.1),
        ]
    };
    let fresh = (spring(0, dec!(2)), pair(ids()));
    for scheme in SPLITTINGS {
        for mut other in SPLITTINGS {
            for rate in [60, 25] {
                let (mut used, step) = (fresh, Step::hz(rate).unwrap());
                scene().step(&mut other, &mut used.0, &step);
                scene().step(&mut other, &mut used.1, &step);
                assert_eq!(of(used, scheme), of(fresh, scheme));
            }
        }
    }
}
