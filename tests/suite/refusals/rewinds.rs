//! Steps that are not undone.

use fixstep::{Push, RangeChecked, Reversible, Verlet};

use super::*;

type Scene = World<RangeChecked<Point<I16F16>>, 1>;

/// A body at rest, and its name.
fn scene() -> (Scene, BodyId) {
    let mut world = Scene::new();
    let id = world.add(RangeChecked::new(point(1).unwrap())).unwrap();
    (world, id)
}

/// What the world says when the last of `steps` steps is to be undone. Nothing changes.
fn back(
    (mut world, _): (Scene, BodyId),
    mut forces: impl Reversible<RangeChecked<Point<I16F16>>>,
    steps: u32,
) -> String {
    let step = Step::hz(60).unwrap();
    (0..steps).for_each(|_| world.step(&mut Verlet, &mut forces, &step));
    let (bodies, tick) = (world.bodies().to_vec(), world.tick());
    let answer = refused(world.step_back(&mut Verlet, &mut forces, &step));
    assert_eq!((world.bodies(), world.tick()), (&bodies[..], tick));
    answer
}

pub fn from_0() -> Errors {
    vec![back(scene(), GravityY::new(-8).unwrap(), 0)]
}

pub fn from_outside() -> Errors {
    let kicked = |impulses: [i32; 3]| {
        let (mut world, id) = scene();
        for impulse in impulses {
            world.get_mut(id).unwrap().push(vec2(impulse, 0).unwrap());
        }
        (world, id)
    };
    // On the way back the push up would come first.
    let fast = kicked([30_000, 0, 0]);
    let pushes = |force| [Push::new(fast.1, vec2(force, 0).unwrap()); 12];
    let down_and_up = (pushes(-30_000), pushes(30_000));
    vec![
        back(kicked([30_000, 30_000, -30_000]), (), 1),
        back(fast, down_and_up, 1),
    ]
}

pub fn through_damping() -> Errors {
    let (world, id) = scene();
    vec![back(
        (world, id),
        Anchor::new(id, vec2(1, 1).unwrap(), 5, 1).unwrap(),
        1,
    )]
}
