//! The gravity scene with one thing more, for images that are weighed against it.

use core::hint::black_box;

use fixstep::fixed::types::I16F16;
use fixstep::{Body, BodyId, DyadicStep, Error, Force, Method, Point, SemiImplicitEuler, World};

use crate::print;
use crate::scene::{self, POINTS};

/// The point of the scene.
pub type Ball = Point<I16F16>;

/// The world of the scene.
pub type Scene = World<Ball, POINTS>;

/// Gravity, and a force that `more` makes for the first two bodies.
pub fn force<F: Force<Point<I16F16>>>(
    more: impl FnOnce([BodyId; 2]) -> Result<F, Error>,
) -> Result<(), Error> {
    let mut world = Scene::new();
    scene::build(&mut world)?;
    let step = DyadicStep::<I16F16, 1, 6>::new()?;
    let ids = world.ids();
    let (Some(&first), Some(&second)) = (ids.first(), ids.get(1)) else {
        return Ok(());
    };
    let mut forces = (scene::gravity()?, more([first, second])?);
    scene::run(&mut world, &mut SemiImplicitEuler, &step, &mut forces, 600);
    black_box(&world);
    Ok(())
}

/// Gravity on other bodies, or by another method.
pub fn method<B>(mut method: impl Method<B, POINTS>) -> Result<(), Error>
where
    B: Body<S = I16F16> + From<Ball>,
{
    let mut world = World::<B, POINTS>::new();
    scene::build(&mut world)?;
    let step = DyadicStep::<I16F16, 1, 6>::new()?;
    let mut gravity = scene::gravity()?;
    scene::run(&mut world, &mut method, &step, &mut gravity, 600);
    black_box(&world);
    Ok(())
}

/// Gravity, with `before` asked how many steps to make and `after` shown the world.
pub fn steps(
    before: impl FnOnce() -> Result<u32, Error>,
    after: impl FnOnce(&mut Scene),
) -> Result<(), Error> {
    let mut world = Scene::new();
    scene::build(&mut world)?;
    let step = DyadicStep::<I16F16, 1, 6>::new()?;
    let mut gravity = scene::gravity()?;
    let due = before()?;
    scene::run(&mut world, &mut SemiImplicitEuler, &step, &mut gravity, due);
    after(&mut world);
    black_box(&world);
    Ok(())
}

/// Ends the image as `gravity` ends.
pub fn end(result: Result<(), Error>) -> ! {
    let _ = black_box(result);
    print::number(black_box(0), 16);
    print::exit()
}
