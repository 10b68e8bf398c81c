//! Instructions of a body in a step, for every run of a chart's scene; tab-separated. The starts are
//! unlike those of the charts, which have sixteen: what a step costs depends little on them.

use core::hint::black_box;

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{Body, Carried, Decay, Error, Force, Method, Point, Step, Vec2, dec, vec2};

use crate::scenes::{MASSES, ROOM, Room, Scene, Visitor};
use crate::{count, print};

/// Steps that are counted, after as many that are not.
const STEPS: u32 = 60;

struct Pricer {
    scene: &'static str,
    body: &'static str,
    bodies: usize,
}

impl Pricer {
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

#[inline(never)]
fn steps<B, M, F>(world: &mut Room<B>, method: &mut M, forces: &mut F, step: &Step<B::S>)
where
    B: Body,
    M: Method<B, ROOM>,
    F: Force<B>,
{
    for _ in 0..STEPS {
        world.step(method, forces, step);
    }
}

impl<B: Body + From<Point<B::S>>> Visitor<B> for Pricer {
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
        let (mut stages, mut acting) = (new(), build(&world)?);
        let step = black_box(Step::hz(60)?);
        steps(black_box(&mut world), &mut stages, &mut acting, &step);
        let start = count::now();
        steps(black_box(&mut world), &mut stages, &mut acting, &step);
        let counted = count::now() - start;
        for text in [
            "chart ", self.scene, " ", forces, "\t", self.body, "\t1/60\t", method, "\t",
        ] {
            print::text(text);
        }
        print::tenths(counted as u64 * 10 / (STEPS as u64 * self.bodies as u64));
        print::text("\t");
        print::number(world.state_hash(), 16);
        print::text("\n");
        Ok(())
    }
}

fn rows<T: Scene, B>(body: &'static str) -> Result<(), Error>
where
    B: Body<S: Decay> + From<Point<B::S>>,
{
    let (scene, bodies) = (T::NAME, T::BODIES);
    T::show::<B, _>(&mut Pricer {
        scene,
        body,
        bodies,
    })
}

/// Prints all rows of a scene.
pub fn price<T: Scene>() -> Result<(), Error> {
    rows::<T, Point<f32>>("f32")?;
    rows::<T, Point<I16F16>>("I16F16")?;
    rows::<T, Point<I8F24>>("I8F24")?;
    rows::<T, Carried<f32>>("f32 carried")?;
    rows::<T, Carried<I8F24>>("I8F24 carried")
}
