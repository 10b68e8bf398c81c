//! Thirty-two points that fall side by side.

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{
    Body, Carried, ConstantAcceleration, DyadicStep, Error, Euler, GravityY, Method, Pefrl, Point,
    Rk4, Scalar, SemiImplicitEuler, Step, TimeStep, Verlet, World, dec, vec2,
};

use super::{Meter, Name, Start, TICKS};

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

/// Shows the scene with every kind of body, step and method.
pub fn show(meter: &mut impl Meter) -> Result<(), Error> {
    fixed::<Point<I16F16>>(meter, "I16F16")?;
    fixed::<Point<I8F24>>(meter, "I8F24")?;
    fixed::<Carried<I16F16>>(meter, "I16F16 carried")?;
    fixed::<Carried<I8F24>>(meter, "I8F24 carried")?;
    methods::<Point<f32>>(meter, "f32")?;
    methods::<Carried<f32>>(meter, "f32 carried")
}

/// With steps that only fixed point has a use for.
fn fixed<B>(meter: &mut impl Meter, scalar: &'static str) -> Result<(), Error>
where
    B: Body + From<Point<B::S>>,
{
    methods::<B>(meter, scalar)?;
    let (dyadic, frame) = (
        DyadicStep::<_, 1, 6>::new()?,
        DyadicStep::<_, 4389, 18>::new()?,
    );
    row::<B, _, _>(
        meter,
        "1/64",
        scalar,
        "SemiImplicitEuler",
        SemiImplicitEuler,
        &dyadic,
    )?;
    row::<B, _, _>(meter, "1/64", scalar, "Verlet", Verlet, &dyadic)?;
    row::<B, _, _>(
        meter,
        "4389/2^18",
        scalar,
        "SemiImplicitEuler",
        SemiImplicitEuler,
        &frame,
    )
}

fn methods<B>(meter: &mut impl Meter, scalar: &'static str) -> Result<(), Error>
where
    B: Body + From<Point<B::S>>,
{
    let step = &Step::hz(60)?;
    row::<B, _, _>(
        meter,
        "1/60",
        scalar,
        "SemiImplicitEuler",
        SemiImplicitEuler,
        step,
    )?;
    row::<B, _, _>(meter, "1/60", scalar, "Verlet", Verlet, step)?;
    row::<B, _, _>(meter, "1/60", scalar, "Euler", Euler::new(), step)?;
    let constant = ConstantAcceleration::new();
    row::<B, _, _>(
        meter,
        "1/60",
        scalar,
        "ConstantAcceleration",
        constant,
        step,
    )?;
    row::<B, _, _>(meter, "1/60", scalar, "Rk4", Rk4::new(), step)?;
    row::<B, _, _>(meter, "1/60", scalar, "Pefrl", Pefrl::new(), step)
}

fn row<B, M, H>(
    meter: &mut impl Meter,
    length: &'static str,
    scalar: &'static str,
    name: &'static str,
    mut method: M,
    step: &H,
) -> Result<(), Error>
where
    B: Body + From<Point<B::S>>,
    M: Method<B, POINTS>,
    H: TimeStep<B::S>,
{
    let mut world = World::<B, POINTS>::new();
    build(&mut world)?;
    let name = Name {
        scene: ["gravity", length, ""],
        scalar,
        method: name,
        ticks: TICKS,
    };
    let start = Start {
        world: &mut world,
        method: &mut method,
        step,
        forces: &mut gravity()?,
    };
    meter.run(name, POINTS as u32, start);
    Ok(())
}
