//! Instructions per body-step of the gravity scene, by number type, step and method.
#![no_std]
#![no_main]

use core::hint::black_box;

use cortex_m_rt::entry;
use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{DyadicStep, Error, Method, Point, Scalar, SemiImplicitEuler, Step, TimeStep, Verlet, World};
use fixstep_firmware::scene::{self, POINTS};
use fixstep_firmware::{count, print};

/// Steps that are counted, after as many that are not.
const STEPS: u32 = 64;

fn row<S, M, H>(name: &str, method: M, step: Result<H, Error>) -> Result<(), Error>
where
    S: Scalar,
    M: Method<Point<S>, POINTS> + Copy,
    H: TimeStep<S>,
{
    let mut world = World::new();
    scene::build::<S>(&mut world)?;
    let mut gravity = scene::gravity::<S>()?;
    let step = black_box(step?);
    scene::run(black_box(&mut world), method, &step, &mut gravity, STEPS);
    let start = count::now();
    scene::run(black_box(&mut world), method, &step, &mut gravity, STEPS);
    let counted = count::now() - start;
    print::text(name);
    print::text("\t");
    let hundredths = counted as u64 * 100 / (STEPS as u64 * POINTS as u64);
    print::number(hundredths / 100, 10);
    print::text(".");
    print::number(hundredths / 10 % 10, 10);
    print::number(hundredths % 10, 10);
    print::text("\t");
    print::number(world.state_hash(), 16);
    print::text("\n");
    Ok(())
}

fn rows() -> Result<(), Error> {
    row::<I16F16, _, _>("I16F16 1/60 SemiImplicitEuler", SemiImplicitEuler, Step::hz(60))?;
    row::<I8F24, _, _>("I8F24 1/60 SemiImplicitEuler", SemiImplicitEuler, Step::hz(60))?;
    row::<I16F16, _, _>("I16F16 1/64 SemiImplicitEuler", SemiImplicitEuler, DyadicStep::<_, 1, 6>::new())?;
    row::<f32, _, _>("f32 1/60 SemiImplicitEuler", SemiImplicitEuler, Step::hz(60))?;
    row::<I16F16, _, _>("I16F16 1/60 Verlet", Verlet, Step::hz(60))?;
    row::<I16F16, _, _>("I16F16 1/64 Verlet", Verlet, DyadicStep::<_, 1, 6>::new())?;
    row::<f32, _, _>("f32 1/60 Verlet", Verlet, Step::hz(60))
}

#[entry]
fn main() -> ! {
    count::start();
    if rows().is_err() {
        print::text("error\n");
    }
    print::exit()
}
