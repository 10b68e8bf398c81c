//! Two scenes that go on for ten minutes. The pendulum is chaotic: what differs by a bit anywhere has
//! then spread over all of the state.

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{
    Anchor, Body, Carried, Decay, Error, ExactDrag, Force, GravityY, Method, Pairs, Point, Pull,
    SemiImplicitEuler, Spring, Step, Verlet, World, dec, vec2,
};

use super::{LONG_TICKS, Meter, Name, Start};

/// Shows both scenes in six kinds of bodies.
pub fn show(meter: &mut impl Meter) -> Result<(), Error> {
    both::<Point<I16F16>>(meter, "I16F16")?;
    both::<Point<I8F24>>(meter, "I8F24")?;
    both::<Point<f32>>(meter, "f32")?;
    both::<Carried<I16F16>>(meter, "I16F16 carried")?;
    both::<Carried<I8F24>>(meter, "I8F24 carried")?;
    both::<Carried<f32>>(meter, "f32 carried")
}

fn both<B>(meter: &mut impl Meter, scalar: &'static str) -> Result<(), Error>
where
    B: Body<S: Decay> + From<Point<B::S>>,
{
    pendulum::<B>(meter, scalar)?;
    stars::<B>(meter, scalar)
}

/// A weight on a stiff spring below another that hangs from an anchor: a double pendulum of rubber.
fn pendulum<B>(meter: &mut impl Meter, scalar: &'static str) -> Result<(), Error>
where
    B: Body<S: Decay> + From<Point<B::S>>,
{
    let mut world = World::<B, 2>::new();
    let upper = world.add(Point::new(vec2(2, 1)?, vec2(0, 0)?, dec!(1.25))?.into());
    let lower = world.add(Point::new(vec2(4, 2)?, vec2(1, 0)?, 1)?.into());
    let (upper, lower) = (upper?, lower?);
    let forces = (
        GravityY::new(dec!(-9.81))?,
        Anchor::new(upper, vec2(0, 0)?, 20, 0)?,
        Pairs::new(Spring::new(2, 40, 0)?, [[upper, lower]]),
    );
    let name = Name {
        scene: ["long", "pendulum", ""],
        scalar,
        method: "SemiImplicitEuler",
        ticks: LONG_TICKS,
    };
    run(meter, name, world, SemiImplicitEuler, forces)
}

/// Two stars, softened, and a drag that hardly acts.
fn stars<B>(meter: &mut impl Meter, scalar: &'static str) -> Result<(), Error>
where
    B: Body<S: Decay> + From<Point<B::S>>,
{
    let mut world = World::<B, 2>::new();
    let heavy = world.add(Point::new(vec2(0, 0)?, vec2(0, dec!(-0.25))?, 2)?.into());
    let light = world.add(Point::new(vec2(3, 0)?, vec2(0, dec!(0.5))?, 1)?.into());
    let forces = (
        Pairs::new(Pull::new(1, dec!(0.25))?, [[heavy?, light?]]),
        ExactDrag::new(dec!(0.0001))?,
    );
    let name = Name {
        scene: ["long", "stars", ""],
        scalar,
        method: "Verlet",
        ticks: LONG_TICKS,
    };
    run(meter, name, world, Verlet, forces)
}

fn run<B, M, F>(
    meter: &mut impl Meter,
    name: Name,
    mut world: World<B, 2>,
    mut method: M,
    mut forces: F,
) -> Result<(), Error>
where
    B: Body,
    M: Method<B, 2>,
    F: Force<B>,
{
    let start = Start {
        world: &mut world,
        method: &mut method,
        step: &Step::hz(60)?,
        forces: &mut forces,
    };
    meter.run(name, 2, start);
    Ok(())
}
