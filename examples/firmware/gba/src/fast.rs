//! The gravity scene as ARM code in fast RAM: cycles of a body in a step. The bits are those of the row
//! that `price` prints for the same step, whose code is Thumb in the cartridge.
#![no_std]
#![no_main]

use core::hint::black_box;

use board::{Long, This};
use fixstep::fixed::types::I16F16;
use fixstep::{DyadicStep, Error, GravityY, Point, SemiImplicitEuler, Step, TimeStep, World};
use measure::Priced;
use measure::scenes::gravity::{POINTS, build, gravity};
use measure::scenes::{Meter, Name};

/// Steps that are counted; the bits are looked at behind them.
const STEPS: u32 = 600;

type Scene = World<Point<I16F16>, POINTS>;

/// Everything below is inlined into it, and so becomes ARM code too.
#[inline(never)]
#[instruction_set(arm::a32)]
#[unsafe(link_section = ".iwram.run")]
fn run<H: TimeStep<I16F16>>(world: &mut Scene, forces: &mut GravityY<I16F16>, step: &H) {
    for _ in 0..STEPS {
        world.step(&mut SemiImplicitEuler, forces, step);
    }
}

fn row<H: TimeStep<I16F16>>(
    priced: &mut Priced<This>,
    length: &'static str,
    step: &H,
) -> Result<(), Error> {
    let mut world = Scene::new();
    build(&mut world)?;
    let mut forces = gravity()?;
    let name = Name {
        scene: ["gravity", length, "in IWRAM"],
        scalar: "I16F16",
        method: "SemiImplicitEuler",
        ticks: &[],
    };
    let start = black_box(&mut world);
    let work = move || {
        run(start, &mut forces, step);
        start
    };
    priced.work(name, POINTS as u32 * STEPS, work, |end| end.state_hash());
    Ok(())
}

board::image!(|board| {
    let priced = &mut Priced::new(board);
    row(priced, "4389/2^18", &DyadicStep::<_, 4389, 18>::new()?)?;
    row(
        priced,
        "4389/2^18 by Long",
        &Long::new(Long::<I16F16>::PICTURE)?,
    )?;
    row(priced, "1/64", &DyadicStep::<_, 1, 6>::new()?)?;
    row(priced, "1/60", &Step::hz(60)?)
});
