//! The gravity scene and nothing else: what it adds to `empty` is what it costs in flash.
#![no_std]
#![no_main]

use core::hint::black_box;

use cortex_m_rt::entry;
use fixstep::fixed::types::I16F16;
use fixstep::{DyadicStep, Error, Point, SemiImplicitEuler, World};
use fixstep_firmware::{print, scene};

fn fall() -> Result<(), Error> {
    let mut world = World::<Point<I16F16>, _>::new();
    scene::build(&mut world)?;
    let step = DyadicStep::<I16F16, 1, 6>::new()?;
    scene::run(
        &mut world,
        &mut SemiImplicitEuler,
        &step,
        &mut scene::gravity()?,
        600,
    );
    black_box(&world);
    Ok(())
}

#[entry]
fn main() -> ! {
    let _ = black_box(fall());
    print::number(black_box(0), 16);
    print::exit()
}
