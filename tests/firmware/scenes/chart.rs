//! The charts' seven scenes, every run of them: no cost is of another scene than its error. The starts are
//! unlike those of the charts, which have sixteen; what a step costs depends little on them.

#[path = "../../../lab/examples/charts/rotor.rs"]
mod rotor;
#[path = "../../../lab/examples/charts/scenes.rs"]
mod scenes;

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::rigid::Centre;
use fixstep::{Body, Carried, Decay, Error, Force, Method, Point, Rigid, Step, Vec2, dec, vec2};

pub use rotor::Rotor;
pub use scenes::{Cluster, Kepler, Pair, Projectile, QuadraticProjectile, Scene, Springs};

use super::{Meter, Name, Start, TICKS};
use scenes::{MASSES, ROOM, Room, Visitor};

/// Shows the runs of a scene to a meter.
struct Shown<'a, M> {
    meter: &'a mut M,
    scene: &'static str,
    scalar: &'static str,
    bodies: usize,
}

impl<M> Shown<'_, M> {
    /// Bodies that move for as long as is counted: no force finds them at rest, none meets another.
    fn world<B: Body + From<Point<B::S>>>(&self) -> Result<Room<B>, Error> {
        let mut world = Room::<B>::new();
        for i in 0..self.bodies as i32 {
            let (position, velocity) = match self.bodies {
                2 => (vec2(3 * i, 0)?, vec2(0, dec!(0.25))?),
                _ => (vec2(3 * i - 5, i * i - 4)?, vec2(i - 1, 2 - i)?),
            };
            let velocity: Vec2<B::S> = velocity;
            let mass = if self.scene == "pair" {
                MASSES.get(i as usize)
            } else {
                None
            };
            let mass = mass.copied().unwrap_or(dec!(1));
            let _ = world.add(Point::new(position, velocity, mass)?.into());
        }
        Ok(world)
    }
}

impl<T: Meter, B: Body + From<Point<B::S>>> Visitor<B> for Shown<'_, T> {
    fn run<M, F>(
        &mut self,
        method: &'static str,
        forces: &'static str,
        new: fn() -> M,
        build: fn(&Room<B>) -> Result<F, Error>,
    ) -> Result<(), Error>
    where
        M: Method<B, ROOM>,
        F: Force<B>,
    {
        let mut world = self.world::<B>()?;
        let mut acting = build(&world)?;
        let name = Name {
            scene: ["chart", self.scene, forces],
            scalar: self.scalar,
            method,
            ticks: TICKS,
        };
        let start = Start {
            world: &mut world,
            method: &mut new(),
            step: &Step::hz(60)?,
            forces: &mut acting,
        };
        self.meter.run(name, self.bodies as u32, start);
        Ok(())
    }
}

fn rows<T: Scene, B>(meter: &mut impl Meter, scalar: &'static str) -> Result<(), Error>
where
    B: Body<S: Decay> + From<Point<B::S>>,
{
    let (scene, bodies) = (T::NAME, T::BODIES);
    T::show::<B, _>(&mut Shown {
        meter,
        scene,
        scalar,
        bodies,
    })
}

/// Shows the runs of the rotor. As in the chart its bodies stay in their places.
struct Turned<'a, M> {
    meter: &'a mut M,
    scalar: &'static str,
}

impl<T: Meter, C: Centre + From<Point<C::S>>> Visitor<Rigid<C>> for Turned<'_, T> {
    fn run<M, F>(
        &mut self,
        method: &'static str,
        forces: &'static str,
        new: fn() -> M,
        build: fn(&Room<Rigid<C>>) -> Result<F, Error>,
    ) -> Result<(), Error>
    where
        M: Method<Rigid<C>, ROOM>,
        F: Force<Rigid<C>>,
    {
        let mut world = Room::<Rigid<C>>::new();
        for spin in [dec!(0.125), dec!(-0.625), dec!(0.375), dec!(-0.875)] {
            let _ = world.add(Rotor::body(dec!(0.3), spin)?);
        }
        let mut acting = build(&world)?;
        let name = Name {
            scene: ["chart", Rotor::NAME, forces],
            scalar: self.scalar,
            method,
            ticks: TICKS,
        };
        let start = Start {
            world: &mut world,
            method: &mut new(),
            step: &Step::hz(60)?,
            forces: &mut acting,
        };
        self.meter.run(name, Rotor::BODIES as u32, start);
        Ok(())
    }
}

fn turned<C>(meter: &mut impl Meter, scalar: &'static str) -> Result<(), Error>
where
    C: Centre<S: Decay> + From<Point<C::S>>,
{
    Rotor::show::<C, _>(&mut Turned { meter, scalar })
}

/// A scene that a chart is made of.
pub trait Chart {
    /// All its runs, in five kinds of bodies.
    fn all(meter: &mut impl Meter) -> Result<(), Error>;
}

impl<T: Scene> Chart for T {
    fn all(meter: &mut impl Meter) -> Result<(), Error> {
        rows::<T, Point<f32>>(meter, "f32")?;
        rows::<T, Point<I16F16>>(meter, "I16F16")?;
        rows::<T, Point<I8F24>>(meter, "I8F24")?;
        rows::<T, Carried<f32>>(meter, "f32 carried")?;
        rows::<T, Carried<I8F24>>(meter, "I8F24 carried")
    }
}

impl Chart for Rotor {
    fn all(meter: &mut impl Meter) -> Result<(), Error> {
        turned::<Point<f32>>(meter, "f32")?;
        turned::<Point<I16F16>>(meter, "I16F16")?;
        turned::<Point<I8F24>>(meter, "I8F24")?;
        turned::<Carried<f32>>(meter, "f32 carried")?;
        turned::<Carried<I8F24>>(meter, "I8F24 carried")
    }
}

/// All runs of a scene, in five kinds of bodies.
pub fn show<T: Chart>(meter: &mut impl Meter) -> Result<(), Error> {
    T::all(meter)
}
