//! Instructions of each force for a body or pair and step, more than the scene without it, and of
//! what is done beside the steps; tab-separated.
#![no_std]
#![no_main]

use core::hint::black_box;

use cortex_m_rt::entry;
use fixstep::fixed::types::I16F16;
use fixstep::{Body, Carried, Decay, Error, Force, Point, Step, Stored};
use fixstep_firmware::force_scene::{self, Eight, Meter};
use fixstep_firmware::{count, print};

/// Steps that are counted, after as many that are not.
const STEPS: u32 = 100;

/// Prints a row a force, and remembers what the first costs.
struct Counter {
    body: &'static str,
    without: Option<u32>,
}

impl Counter {
    fn row(&mut self, name: &str, counted: u32, units: u32, hash: u64) {
        let Some(without) = self.without else {
            self.without = Some(counted);
            return;
        };
        print::text(name);
        print::text("\t");
        print::text(self.body);
        print::text("\t1/60\tSemiImplicitEuler\t");
        let more = counted.saturating_sub(without) as u64;
        print::tenths(more * 10 / units as u64);
        print::text("\t");
        print::number(hash, 16);
        print::text("\n");
    }
}

impl<B: Body + From<Point<B::S>>> Meter<B> for Counter {
    fn force<F: Force<B>>(&mut self, name: &str, units: u32, mut force: F) -> Result<(), Error> {
        let mut world = Eight::<B>::new();
        force_scene::build(&mut world)?;
        let step = black_box(Step::hz(60)?);
        force_scene::run(black_box(&mut world), &mut force, &step, STEPS);
        let start = count::now();
        force_scene::run(black_box(&mut world), &mut force, &step, STEPS);
        let counted = count::now() - start;
        self.row(name, counted, units * STEPS, world.state_hash());
        Ok(())
    }

    fn work<T>(&mut self, name: &str, units: u32, work: impl FnOnce() -> T, hash: fn(T) -> u64) {
        let start = count::now();
        let made = black_box(work());
        let counted = count::now() - start;
        self.row(name, counted, units, hash(made));
    }
}

fn counter(body: &'static str) -> Counter {
    Counter {
        body,
        without: None,
    }
}

fn rows<S>(body: &'static str) -> Result<(), Error>
where
    S: Decay<InvMass: Stored> + Stored,
{
    force_scene::forces::<Point<S>>(&mut counter(body))?;
    force_scene::beside::<S>(&mut counter(body))
}

fn all() -> Result<(), Error> {
    rows::<I16F16>("I16F16")?;
    rows::<f32>("f32")?;
    force_scene::forces::<Carried<I16F16>>(&mut counter("I16F16 carried"))
}

#[entry]
fn main() -> ! {
    count::start();
    match all() {
        Ok(()) => print::exit(),
        Err(_) => print::fail("a constructor refused a value\n"),
    }
}
