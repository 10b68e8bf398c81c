//! What a minute at 60 Hz leaves of a fall, a spring and an orbit: a row for each combination that ships.
//! The README shows the table.

use indicatif::ProgressBar;

use crate::cost::{Core, Costs};
use crate::figures::Row;
use crate::minute_table::{COMBINATIONS, HEADER, KEYS};
use crate::run::{Course, Outcome};
use crate::starts::Plan;
use crate::table::{Effort, Table};
use crate::work::outcomes;

const SECONDS: u32 = 60;
const RATE: u32 = 60;

/// All runs of a scene, and its size.
type Runs = (Vec<Outcome>, f64);

/// Quick and full are the same.
pub fn make(name: &'static str, _: Effort, progress: &ProgressBar) -> Result<Table, String> {
    let costs = Costs::load()?;
    let found = |scene| -> Result<Runs, String> {
        let course = Course::new(Plan::of(scene).lasting(SECONDS));
        Ok((outcomes(&course, &[RATE], progress)?, course.plan.size))
    };
    let (falls, springs, orbits) = (found("projectile")?, found("spring")?, found("kepler")?);
    let row = |[method, drag, spring, body]: [&str; 4]| {
        let run = [method, drag, body];
        let cost = |core| {
            costs
                .get(core, "projectile", run)
                .map(|cost| format!("{cost:.1}"))
        };
        let mut cells = [method, drag, spring, body].map(String::from).to_vec();
        cells.extend([cost(Core::M0Plus)?, cost(Core::M4F)?]);
        cells.push(error(&falls, run)?);
        cells.push(error(&springs, [method, spring, body])?);
        cells.push(error(&orbits, [method, "Pull", body])?);
        Ok(cells)
    };
    Ok(Table {
        name,
        keys: KEYS,
        header: HEADER.to_vec(),
        rows: COMBINATIONS
            .into_iter()
            .map(row)
            .collect::<Result<_, String>>()?,
    })
}

/// The median error of a run.
fn error((all, size): &Runs, run: [&str; 3]) -> Result<String, String> {
    let is = |outcome: &&Outcome| [outcome.method, outcome.forces, outcome.body] == run;
    let outcome = all
        .iter()
        .find(is)
        .ok_or_else(|| format!("no run {}", run.join(" ")))?;
    let row = Row::of(run, RATE, [0.0; 2], &outcome.errors, *size);
    Ok(format!("{:.2e}", row.errors[1]))
}
