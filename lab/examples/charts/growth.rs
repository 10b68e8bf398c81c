//! How the error of rounding alone grows with the number of steps, to ten million: a cruise beside
//! `v t`, a spring and the oscillator of `tests/sweeps/rounding` each beside its own map in `f64`, with the
//! coefficients that the type holds.

#[allow(dead_code)]
#[path = "../../tests/sweeps/rounding/duffing.rs"]
mod duffing;
#[path = "growth/picture.rs"]
mod picture;
#[path = "growth/scenes.rs"]
mod scenes;

use std::path::Path;
use std::thread;

use fixstep::fixed::types::{I8F24, I12F20, I16F16};
use fixstep::{Carried, Point};
use indicatif::ProgressBar;

use crate::canvas::Drawn;
use crate::figures::quantile;
use crate::table::{Effort, Table};
use scenes::{Counts, Kind};

/// Steps at which errors are taken, half a decade apart; a quick run ends at the seventh.
const COUNTS: [u32; 11] = [
    100, 316, 1_000, 3_162, 10_000, 31_623, 100_000, 316_228, 1_000_000, 3_162_278, 10_000_000,
];
const QUICK: usize = 7;

/// A scene: its errors at each count, one for each start.
type Run = fn(&Counts) -> Vec<Vec<f64>>;

fn scenes<B: Kind>() -> [(&'static str, Run); 3] {
    [
        ("cruise", scenes::cruise::<B>),
        ("spring", scenes::spring::<B>),
        ("oscillator", scenes::oscillator::<B>),
    ]
}

/// A kind of body: its name and its scenes.
type Column = (String, [(&'static str, Run); 3]);

fn kind<B: Kind>() -> Column {
    (B::name(), scenes::<B>())
}

/// What one kind of body does.
fn rows((body, scenes): &Column, counts: &Counts, progress: &ProgressBar) -> Vec<Vec<String>> {
    let mut rows = vec![];
    for (scene, run) in scenes {
        for (steps, errors) in counts.iter().zip(run(counts)) {
            rows.push(row(scene, body, *steps, errors));
        }
        progress.inc(1);
    }
    rows
}

pub fn make(effort: Effort, progress: &ProgressBar) -> Table {
    let counts = match effort {
        Effort::Quick => &COUNTS[..QUICK],
        Effort::Full => &COUNTS,
    };
    let kinds = [
        kind::<Point<f32>>(),
        kind::<Carried<f32>>(),
        kind::<Point<I16F16>>(),
        kind::<Point<I12F20>>(),
        kind::<Point<I8F24>>(),
        kind::<Carried<I8F24>>(),
    ];
    progress.inc_length(3 * kinds.len() as u64);
    let rows = thread::scope(|scope| {
        let runs = kinds.map(|kind| scope.spawn(move || rows(&kind, counts, progress)));
        runs.map(|run| run.join().expect("a run ends")).concat()
    });
    Table {
        name: "growth",
        keys: 3,
        header: vec!["scene", "body", "steps", "low", "median", "high"],
        rows,
    }
}

/// The median of the starts, and between what nine tenths of them lie.
fn row(scene: &str, body: &str, steps: u32, errors: Vec<f64>) -> Vec<String> {
    let at = |share: f64| format!("{:.2e}", quantile(&errors, share));
    let mut row = vec![scene.into(), body.into(), steps.to_string()];
    row.extend([0.05, 0.5, 0.95].map(at));
    row
}

/// Writes `growth.png`.
pub fn draw(folder: &Path, table: &Table) -> Drawn {
    picture::draw(&folder.join("growth.png"), table)
}
