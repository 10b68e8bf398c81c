//! Where each method is stable: springs by `ω h` and damping ratio, drag by `k h / m` and `h c |v| / m`.
//! Every cell is runs in `I16F16`; the lines are closed forms. Cells, laws and runs are those of
//! `tests/sweeps/stability`.

#[allow(dead_code)]
#[path = "../../tests/sweeps/stability/drag.rs"]
mod drag;
#[path = "../../tests/sweeps/stability/drag_cell.rs"]
mod drag_cell;
#[allow(dead_code)]
#[path = "../../tests/sweeps/stability/law.rs"]
mod law;
#[allow(dead_code)]
#[path = "../../tests/sweeps/stability/run.rs"]
mod run;
#[allow(dead_code)]
#[path = "../../tests/sweeps/stability/scene.rs"]
mod scene;

#[path = "maps/drags.rs"]
mod drags;
#[path = "maps/springs.rs"]
mod springs;

use std::path::Path;
use std::thread;

use fixstep::fixed::types::I16F16;
use indicatif::ProgressBar;

use crate::canvas::Drawn;
use crate::table::{Effort, Table};
use drag_cell::KINDS;
use law::{DRAGS, Drag, LAWS, Law};
use scene::Swing;

/// Rows of a map of springs; a quick run makes each eighth.
const ROWS: usize = 24;
const QUICK: usize = 8;

/// Damping ratios from 0.01 to 5.
fn zeta(row: usize) -> f64 {
    0.01 * 500.0_f64.powf(row as f64 / (ROWS - 1) as f64)
}

fn drag_name(drag: Drag) -> &'static str {
    match drag {
        Drag::Explicit => "spring and explicit drag",
        Drag::Exact => "spring and exact drag",
    }
}

/// Of one method: its springs, then its drags.
fn rows(law: &Law, every: usize, progress: &ProgressBar) -> Vec<Vec<String>> {
    let mut rows = vec![];
    for drag in DRAGS {
        for i in (0..ROWS).step_by(every) {
            rows.push(spring(law, drag, i));
            progress.inc(1);
        }
    }
    for kind in KINDS {
        let courses = kind.columns().map(|rate| kind.course::<I16F16>(law, rate));
        let limits = [kind.measured_limit(law), kind.limit(law)];
        rows.push(row(law, kind.name(), "", drag_cell::row(courses), limits));
        progress.inc(1);
    }
    rows
}

pub fn make(effort: Effort, progress: &ProgressBar) -> Table {
    let every = if effort == Effort::Quick { QUICK } else { 1 };
    progress.inc_length((LAWS.len() * (2 * ROWS.div_ceil(every) + KINDS.len())) as u64);
    let rows = thread::scope(|scope| {
        let runs = LAWS
            .each_ref()
            .map(|law| scope.spawn(move || rows(law, every, progress)));
        runs.map(|run| run.join().expect("a run ends")).concat()
    });
    Table {
        name: "maps",
        keys: 3,
        header: vec![
            "method",
            "force",
            "damping_ratio",
            "cells",
            "measured_limit",
            "limit",
        ],
        rows,
    }
}

/// A row of cells: `.` bounded, `#` not.
fn spring(law: &Law, drag: Drag, i: usize) -> Vec<String> {
    let zeta = zeta(i);
    let cell = |q| match run::bounded::<I16F16>(law, Swing { drag, q, zeta }) {
        true => '.',
        false => '#',
    };
    let limits = [run::measured_limit(law, drag, zeta), law.limit(drag, zeta)];
    let cells = run::columns().map(cell).collect();
    row(law, drag_name(drag), &format!("{zeta:.4}"), cells, limits)
}

fn row(law: &Law, force: &str, zeta: &str, cells: String, limits: [f64; 2]) -> Vec<String> {
    let [measured, closed] = limits.map(|limit| format!("{limit:.4}"));
    let method = format!("{:?}", law.scheme);
    vec![method, force.into(), zeta.into(), cells, measured, closed]
}

/// The cells of a row of the table, by its first columns.
fn cells<'a>(table: &'a Table, method: &str, force: &str, zeta: &str) -> Option<&'a str> {
    let named = |row: &&Vec<String>| row[..3] == [method, force, zeta];
    table.rows.iter().find(named).map(|row| row[3].as_str())
}

/// Writes `maps.png`, the springs, and `maps-drag.png`.
pub fn draw(folder: &Path, table: &Table) -> Drawn {
    springs::draw(&folder.join("maps.png"), table)?;
    drags::draw(&folder.join("maps-drag.png"), table)
}
