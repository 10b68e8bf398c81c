//! A day of 1/60 s: added up in `f32`, and as ticks. `[hours, seconds off]`, each half hour.

use fixstep::{Point, SemiImplicitEuler, Step, World};

const TICKS: u32 = 24 * 3600 * 60;
const EVERY: u32 = 1800 * 60;

fn day(mut seconds: impl FnMut() -> f64) -> Vec<[f64; 2]> {
    let mut found = vec![[0.0; 2]];
    for n in 1..=TICKS {
        let seconds = seconds();
        if n.is_multiple_of(EVERY) {
            found.push([f64::from(n) / 216_000.0, seconds - f64::from(n) / 60.0]);
        }
    }
    found
}

pub fn added() -> Vec<[f64; 2]> {
    let mut t = 0.0_f32;
    day(|| {
        t += 1.0 / 60.0;
        f64::from(t)
    })
}

/// The clock of a world: rounded to `f32` once.
pub fn counted() -> Vec<[f64; 2]> {
    let (mut world, step) = (World::<Point<f32>, 1>::new(), Step::hz(60).unwrap());
    day(|| {
        world.step(&mut SemiImplicitEuler, &mut (), &step);
        f64::from(world.time(&step).seconds::<f32>())
    })
}
