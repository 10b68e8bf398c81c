//! Instructions per body-step of the gravity scene, by body, step and method; tab-separated.
#![no_std]
#![no_main]

use core::hint::black_box;

use cortex_m_rt::entry;
use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{
    Body, Carried, ConstantAcceleration, DyadicStep, Error, Euler, Method, Pefrl, Point, Rk4,
    Scalar, SemiImplicitEuler, Step, TimeStep, Verlet, World,
};
use fixstep_firmware::scene::{self, POINTS};
use fixstep_firmware::{count, print};

/// Steps that are counted, after as many that are not.
const STEPS: u32 = 300;

fn row<B, M, H>(name: &str, mut method: M, step: Result<H, Error>) -> Result<(), Error>
where
    B: Body + From<Point<B::S>>,
    M: Method<B, POINTS>,
    H: TimeStep<B::S>,
{
    let mut world = World::<B, POINTS>::new();
    scene::build(&mut world)?;
    let mut gravity = scene::gravity()?;
    let step = black_box(step?);
    scene::run(
        black_box(&mut world),
        &mut method,
        &step,
        &mut gravity,
        STEPS,
    );
    let start = count::now();
    scene::run(
        black_box(&mut world),
        &mut method,
        &step,
        &mut gravity,
        STEPS,
    );
    let counted = count::now() - start;
    print::text(name);
    print::text("\t");
    print::tenths(counted as u64 * 10 / (STEPS as u64 * POINTS as u64));
    print::text("\t");
    print::number(world.state_hash(), 16);
    print::text("\n");
    Ok(())
}

/// What a loop of known length counts: `2 n + 5` instructions for n rounds.
fn calibration() {
    for rounds in [0, 1_000, 100_000] {
        print::text("calibration\t");
        print::number(rounds as u64, 10);
        print::text("\t");
        print::number(count::loop_of(rounds) as u64, 10);
        print::text("\n");
    }
}

fn rows() -> Result<(), Error> {
    type Frame<S> = DyadicStep<S, 4389, 18>;
    type Dyadic<S> = DyadicStep<S, 1, 6>;
    row::<Point<I16F16>, _, _>(
        "I16F16\t1/60\tSemiImplicitEuler",
        SemiImplicitEuler,
        Step::hz(60),
    )?;
    row::<Point<I8F24>, _, _>(
        "I8F24\t1/60\tSemiImplicitEuler",
        SemiImplicitEuler,
        Step::hz(60),
    )?;
    row::<Point<I16F16>, _, _>(
        "I16F16\t1/64\tSemiImplicitEuler",
        SemiImplicitEuler,
        Dyadic::new(),
    )?;
    row::<Point<I16F16>, _, _>(
        "I16F16\t4389/2^18\tSemiImplicitEuler",
        SemiImplicitEuler,
        Frame::new(),
    )?;
    row::<Carried<I16F16>, _, _>(
        "I16F16 carried\t1/60\tSemiImplicitEuler",
        SemiImplicitEuler,
        Step::hz(60),
    )?;
    row::<Carried<I16F16>, _, _>(
        "I16F16 carried\t1/64\tSemiImplicitEuler",
        SemiImplicitEuler,
        Dyadic::new(),
    )?;
    row::<Point<f32>, _, _>(
        "f32\t1/60\tSemiImplicitEuler",
        SemiImplicitEuler,
        Step::hz(60),
    )?;
    row::<Carried<f32>, _, _>(
        "f32 carried\t1/60\tSemiImplicitEuler",
        SemiImplicitEuler,
        Step::hz(60),
    )?;
    row::<Point<I16F16>, _, _>("I16F16\t1/60\tVerlet", Verlet, Step::hz(60))?;
    row::<Point<I16F16>, _, _>("I16F16\t1/64\tVerlet", Verlet, Dyadic::new())?;
    row::<Carried<I16F16>, _, _>("I16F16 carried\t1/64\tVerlet", Verlet, Dyadic::new())?;
    row::<Point<f32>, _, _>("f32\t1/60\tVerlet", Verlet, Step::hz(60))?;
    methods::<I16F16>([
        "I16F16\t1/60\tEuler",
        "I16F16\t1/60\tConstantAcceleration",
        "I16F16\t1/60\tRk4",
        "I16F16\t1/60\tPefrl",
    ])?;
    methods::<f32>([
        "f32\t1/60\tEuler",
        "f32\t1/60\tConstantAcceleration",
        "f32\t1/60\tRk4",
        "f32\t1/60\tPefrl",
    ])
}

fn methods<S: Scalar>([euler, constant, rk4, pefrl]: [&str; 4]) -> Result<(), Error> {
    row::<Point<S>, _, _>(euler, Euler::new(), Step::hz(60))?;
    row::<Point<S>, _, _>(constant, ConstantAcceleration::new(), Step::hz(60))?;
    row::<Point<S>, _, _>(rk4, Rk4::new(), Step::hz(60))?;
    row::<Point<S>, _, _>(pefrl, Pefrl::new(), Step::hz(60))
}

#[entry]
fn main() -> ! {
    count::start();
    calibration();
    match rows() {
        Ok(()) => print::exit(),
        Err(_) => print::fail("a constructor refused a value\n"),
    }
}
