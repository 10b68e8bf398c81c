//! The gravity scene: 32 points that fall side by side. The host tests run the same file.

use fixstep::{Body, Error, Force, GravityY, Method, Point, Scalar, TimeStep, World, dec, vec2};

/// Points in the scene.
pub const POINTS: usize = 32;

/// Thirty-two points of 1 kg, each with another height and sideways speed.
pub fn build<B>(world: &mut World<B, POINTS>) -> Result<(), Error>
where
    B: Body + From<Point<B::S>>,
{
    world.clear();
    for i in 0..POINTS as i32 {
        let point = Point::new(vec2(i - 16, 60 + i)?, vec2(16 - i, 0)?, 1)?;
        let _ = world.add(point.into());
    }
    Ok(())
}

/// Gravity along one axis.
pub fn gravity<S: Scalar>() -> Result<GravityY<S>, Error> {
    GravityY::new(dec!(-9.81))
}

/// Makes `steps` steps; not inlined, so that it can be looked at.
#[inline(never)]
pub fn run<B, M, H, F>(
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
