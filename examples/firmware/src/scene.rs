//! The gravity scene: 32 points that fall side by side. The host tests run the same file.

use fixstep::{Error, GravityY, Method, Point, Scalar, TimeStep, World, dec, vec2};

/// Points in the scene.
pub const POINTS: usize = 32;

/// Thirty-two points of 1 kg, each with another height and sideways speed.
pub fn build<S: Scalar>(world: &mut World<Point<S>, POINTS>) -> Result<(), Error> {
    world.clear();
    for i in 0..POINTS as i32 {
        let _ = world.add(Point::new(vec2(i - 16, 60 + i)?, vec2(16 - i, 0)?, 1)?);
    }
    Ok(())
}

/// Gravity along one axis.
pub fn gravity<S: Scalar>() -> Result<GravityY<S>, Error> {
    GravityY::new(dec!(-9.81))
}

/// Makes `steps` steps; not inlined, so that it can be looked at.
#[inline(never)]
pub fn run<S, M, H>(world: &mut World<Point<S>, POINTS>, mut method: M, step: &H, gravity: &mut GravityY<S>, steps: u32)
where
    S: Scalar,
    M: Method<Point<S>, POINTS>,
    H: TimeStep<S>,
{
    for _ in 0..steps {
        world.step(&mut method, gravity, step);
    }
}
