//! Saturation, seen or not at the end of a step, is remembered; and a way back that would saturate is
//! not taken.

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{Anchor, Exact, Push, RewindError};

use super::*;
use crate::support::{Format, point, ratio, spread, vector};

/// Two bodies at 1/64 s, of which the second, of 1 kg, is at `x` with `v`, both in ends of the range.
fn scene<S: Scalar>(x: f64, v: f64) -> (World<RangeChecked<Point<S>>, 2>, BodyId) {
    let end = S::MAX.to_f64();
    let world = watched([
        point([1.0, 2.0], [3.0, 4.0], 1.0),
        point([0.0, x * end], [0.5, v * end], 1.0),
    ]);
    let second = world.ids()[1];
    (world, second)
}

/// A push on `body` that changes its velocity by that part of the range in one step of 1/64 s, made
/// of pushes that are numbers each.
fn kicks<S: Scalar>(body: BodyId, part: f64) -> [Push<S>; 64] {
    [Push::new(body, vector(0.0, part * S::MAX.to_f64())); 64]
}

fn step<S: Scalar>() -> DyadicStep<S, 1, 6> {
    DyadicStep::new().unwrap()
}

/// Steps once, looks at the end of the step as `out_of_range` does, and asks to go back.
fn once<S: Exact, M: Rewinds<RangeChecked<Point<S>>, 2>>(
    mut method: M,
    world: &mut World<RangeChecked<Point<S>>, 2>,
    forces: &mut impl Reversible<RangeChecked<Point<S>>>,
) -> Result<(), RewindError> {
    world.step(&mut method, forces, &step());
    assert_eq!(world.out_of_range().count(), 0, "seen from outside");
    let end = state(world);
    let answer = world.step_back(&mut method, forces, &step());
    if answer.is_err() {
        assert_eq!(state(world), end);
    }
    answer
}

fn velocities_in_the_middle_of_a_step<S: Format + Exact>() {
    for start in 0..16 {
        let size = 0.3 + 0.3 * spread(start);
        // Up by more than there is room for, and down again.
        let (mut world, body) = scene::<S>(0.0, 0.8);
        let mut forces = (kicks(body, size), kicks(body, -size));
        let refused = Err(RewindError::Saturated { body });
        assert_eq!(once(Verlet, &mut world, &mut forces), refused);
        let (mut world, _) = scene::<S>(0.0, -0.8);
        let mut forces = (kicks(body, -size), kicks(body, size));
        assert_eq!(once(SemiImplicitEuler, &mut world, &mut forces), refused);
        // The same where there is room.
        let (mut world, _) = scene::<S>(0.0, 0.3);
        let mut forces = (kicks(body, size), kicks(body, -size));
        assert_eq!(once(Verlet, &mut world, &mut forces), Ok(()));
    }
}

#[test]
fn velocities_that_saturate_in_the_middle_of_a_step_are_remembered() {
    velocities_in_the_middle_of_a_step::<I16F16>();
    velocities_in_the_middle_of_a_step::<I8F24>();
}

// v + a, v + a + b are inside on the way out; -(v + a + b) + a is not on the way back.
#[test]
fn a_way_back_that_would_saturate_is_not_taken() {
    for start in 0..16 {
        let size = 0.3 + 0.3 * spread(start);
        let (mut world, body) = scene::<I16F16>(0.0, 0.8);
        let mut forces = (kicks(body, -size), kicks(body, size));
        let refused = Err(RewindError::Saturated { body });
        assert_eq!(once(Verlet, &mut world, &mut forces), refused);
        assert!(!world.get(body).unwrap().was_outside());
        assert_eq!(once(SemiImplicitEuler, &mut world, &mut forces), refused);
    }
}

// Half a drift beyond the end, a kick that turns it round, half a drift back.
#[test]
fn positions_that_saturate_in_the_middle_of_a_step_are_remembered() {
    for start in 0..16 {
        let speed = 0.5 + 0.4 * spread(start);
        for side in [1.0, -1.0] {
            let (mut world, body) = scene::<I16F16>(side * 0.999, side * speed);
            let half = || kicks(body, side * -0.75 * speed);
            let mut turn = (half(), half());
            let refused = Err(RewindError::Saturated { body });
            assert_eq!(once(Verlet, &mut world, &mut turn), refused);
        }
    }
}

/// An anchor throws it back: outside at some step, inside for long when it is asked.
#[test]
fn a_body_that_was_outside_earlier_is_remembered() {
    for start in 0..16 {
        let (mut world, body) = scene::<I16F16>(0.9, 0.3 + 0.1 * spread(start));
        let anchor = |id| Anchor::new(id, vector(0.0, 0.0), ratio(0.3), 0).unwrap();
        let mut forces = anchor(body);
        let mut outside = 0;
        while outside == 0 || world.out_of_range().count() > 0 {
            world.step(&mut Verlet, &mut forces, &step());
            outside += world.out_of_range().count();
        }
        (0..100).for_each(|_| world.step(&mut Verlet, &mut forces, &step()));
        let refused = Err(RewindError::Saturated { body });
        let end = state(&world);
        assert_eq!(world.step_back(&mut Verlet, &mut forces, &step()), refused);
        assert_eq!(state(&world), end);
        // With the mark the history is given up: it goes back to here, by steps made since.
        for (_, body) in world.iter_mut() {
            body.forget();
        }
        let here = state(&world);
        (0..20).for_each(|_| world.step(&mut Verlet, &mut forces, &step()));
        for _ in 0..20 {
            assert_eq!(world.step_back(&mut Verlet, &mut forces, &step()), Ok(()));
        }
        assert_eq!(state(&world), here);
    }
}
