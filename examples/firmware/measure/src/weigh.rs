//! The gravity scene with one thing more, for images that are weighed against it.

use core::hint::black_box;

use fixstep::fixed::types::I16F16;
use fixstep::{
    Body, BodyId, DyadicStep, Error, Force, Method, Point, Rigid, SemiImplicitEuler, TimeStep,
    World, dec, vec2,
};

use crate::scenes::gravity::{self, POINTS};

/// The point of the scene.
pub type Ball = Point<I16F16>;

/// The world of the scene.
pub type Scene = World<Ball, POINTS>;

#[inline(never)]
fn run<B, M, H, F>(
    world: &mut World<B, POINTS>,
    method: &mut M,
    step: &H,
    forces: &mut F,
    steps: u32,
) where
    B: Body,
    M: Method<B, POINTS>,
    H: TimeStep<B::S>,
    F: Force<B>,
{
    for _ in 0..steps {
        world.step(method, forces, step);
    }
}

/// Gravity, and a force that `more` makes for the first two bodies, for so many steps.
pub fn force<F: Force<Ball>>(
    more: impl FnOnce([BodyId; 2]) -> Result<F, Error>,
    steps: u32,
) -> Result<(), Error> {
    let mut world = Scene::new();
    gravity::build(&mut world)?;
    let step = DyadicStep::<I16F16, 1, 6>::new()?;
    let ids = world.ids();
    let (Some(&first), Some(&second)) = (ids.first(), ids.get(1)) else {
        return Ok(());
    };
    let mut forces = (gravity::gravity()?, more([first, second])?);
    run(
        &mut world,
        &mut SemiImplicitEuler,
        &step,
        &mut forces,
        steps,
    );
    black_box(&world);
    Ok(())
}

/// Gravity on bodies of any kind, by any method.
pub fn method<B>(mut method: impl Method<B, POINTS>) -> Result<(), Error>
where
    B: Body + From<Point<B::S>>,
{
    let mut world = World::<B, POINTS>::new();
    gravity::build(&mut world)?;
    let step = DyadicStep::<B::S, 1, 6>::new()?;
    let mut gravity = gravity::gravity()?;
    run(&mut world, &mut method, &step, &mut gravity, 600);
    black_box(&world);
    Ok(())
}

/// Gravity on as many bodies that turn, and a force that `more` makes for the first two.
pub fn turning<F: Force<Rigid<Ball>>>(
    more: impl FnOnce([BodyId; 2]) -> Result<F, Error>,
) -> Result<(), Error> {
    let mut world = World::<Rigid<Ball>, POINTS>::new();
    for i in 0..POINTS as i32 {
        let point = Point::new(vec2(i - 16, 60 + i)?, vec2(16 - i, 0)?, 1)?;
        let _ = world.add(Rigid::new(point, dec!(0.5))?.with_spin(1)?);
    }
    let step = DyadicStep::<I16F16, 1, 6>::new()?;
    let ids = world.ids();
    let (Some(&first), Some(&second)) = (ids.first(), ids.get(1)) else {
        return Ok(());
    };
    let mut forces = (gravity::gravity()?, more([first, second])?);
    run(&mut world, &mut SemiImplicitEuler, &step, &mut forces, 600);
    black_box(&world);
    Ok(())
}

/// Gravity, with `before` asked how many steps to make and `after` shown the world.
pub fn steps(
    before: impl FnOnce() -> Result<u32, Error>,
    after: impl FnOnce(&mut Scene),
) -> Result<(), Error> {
    let mut world = Scene::new();
    gravity::build(&mut world)?;
    let step = DyadicStep::<I16F16, 1, 6>::new()?;
    let mut gravity = gravity::gravity()?;
    let due = before()?;
    run(&mut world, &mut SemiImplicitEuler, &step, &mut gravity, due);
    after(&mut world);
    black_box(&world);
    Ok(())
}
