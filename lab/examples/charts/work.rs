//! Work and precision: what a simulated second costs on a core, and how wrong it is. One table for each
//! scene; a row for each method, way to state the forces, kind of body and rate.

use std::thread;

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{Carried, Error, Point};
use indicatif::ProgressBar;

use crate::cost::{Core, Costs};
use crate::figures::{KEYS, Row, header};
use crate::rotor::Rotor;
use crate::run::{Course, Outcome};
use crate::scenes::{Cluster, Kepler, Pair, Projectile, QuadraticProjectile, Scene, Springs};
use crate::starts::Plan;
use crate::table::{Effort, Table};

/// Steps a second: all multiples of the looks of a second.
const RATES: [u32; 7] = [15, 30, 60, 120, 240, 480, 960];
const QUICK: [u32; 2] = [60, 120];

/// The table of a scene by its name, which is "work-" and the scene's.
pub fn make(name: &'static str, effort: Effort, progress: &ProgressBar) -> Result<Table, String> {
    let scene = name.trim_start_matches("work-");
    let rates: &[u32] = match effort {
        Effort::Quick => &QUICK,
        Effort::Full => &RATES,
    };
    let (costs, course) = (Costs::load()?, Course::new(Plan::of(scene)));
    let row = |outcome: Outcome| {
        let run = [outcome.method, outcome.forces, outcome.body];
        let cost = |core| costs.get(core, scene, run);
        let costs = [cost(Core::M0Plus)?, cost(Core::M4F)?];
        let (errors, size) = (&outcome.errors, course.plan.size);
        Ok(Row::of(run, outcome.rate, costs, errors, size).cells())
    };
    let rows = outcomes(&course, rates, progress)?;
    Ok(Table {
        name,
        keys: KEYS,
        header: header(course.plan.unit()),
        rows: rows.into_iter().map(row).collect::<Result<_, String>>()?,
    })
}

/// All runs of a scene with all kinds of bodies.
pub fn outcomes(
    course: &Course,
    rates: &[u32],
    progress: &ProgressBar,
) -> Result<Vec<Outcome>, String> {
    let runs = match course.plan.scene {
        Springs::NAME => points::<Springs>(),
        Projectile::NAME => points::<Projectile>(),
        QuadraticProjectile::NAME => points::<QuadraticProjectile>(),
        Kepler::NAME => points::<Kepler>(),
        Pair::NAME => points::<Pair>(),
        Rotor::NAME => rotors(),
        _ => points::<Cluster>(),
    };
    let found = bodies(runs, course, rates, progress);
    found.map_err(|error| format!("{}: {error}", course.plan.scene))
}

/// All runs with a kind of body.
type Run = fn(&Course, &'static str, &[u32]) -> Result<Vec<Outcome>, Error>;
type Runs = [(&'static str, Run); 5];

fn points<T: Scene>() -> Runs {
    [
        ("f32", Course::run::<T, Point<f32>>),
        ("I16F16", Course::run::<T, Point<I16F16>>),
        ("I8F24", Course::run::<T, Point<I8F24>>),
        ("f32 carried", Course::run::<T, Carried<f32>>),
        ("I8F24 carried", Course::run::<T, Carried<I8F24>>),
    ]
}

fn rotors() -> Runs {
    [
        ("f32", Course::run_rotor::<Point<f32>>),
        ("I16F16", Course::run_rotor::<Point<I16F16>>),
        ("I8F24", Course::run_rotor::<Point<I8F24>>),
        ("f32 carried", Course::run_rotor::<Carried<f32>>),
        ("I8F24 carried", Course::run_rotor::<Carried<I8F24>>),
    ]
}

/// A thread for each kind of body.
fn bodies(
    all: Runs,
    course: &Course,
    rates: &[u32],
    progress: &ProgressBar,
) -> Result<Vec<Outcome>, Error> {
    progress.inc_length(all.len() as u64);
    let mut found = Vec::new();
    thread::scope(|scope| {
        let start = |(body, run): (&'static str, Run)| {
            scope.spawn(move || {
                let outcomes = run(course, body, rates);
                progress.inc(1);
                outcomes
            })
        };
        let threads = all.map(start);
        for thread in threads {
            match thread.join() {
                Ok(outcomes) => found.extend(outcomes?),
                Err(panic) => std::panic::resume_unwind(panic),
            }
        }
        Ok(found)
    })
}
