//! What goes wrong: eight faults of simulations in use, each beside what this crate does.

#[path = "wrong/clock.rs"]
mod clock;
#[path = "wrong/far.rs"]
mod far;
#[path = "wrong/panels.rs"]
mod panels;
#[path = "wrong/picture.rs"]
mod picture;
#[path = "wrong/rounding.rs"]
mod rounding;
#[path = "wrong/springs.rs"]
mod springs;

use std::path::Path;

use fixstep::fixed::types::I16F16;
use fixstep::{Euler, SemiImplicitEuler, Verlet};
use indicatif::ProgressBar;

use crate::canvas::Drawn;
use crate::table::{Effort, Table};

/// Panel, line, points.
type Line = (&'static str, &'static str, Vec<[f64; 2]>);

fn springs() -> [Line; 7] {
    let (steps, every) = (600, 10);
    [
        ("euler", "Euler", springs::by(Euler::new(), steps, every)),
        (
            "euler",
            "SemiImplicitEuler",
            springs::by(SemiImplicitEuler, steps, every),
        ),
        ("euler", "Verlet", springs::by(Verlet, steps, every)),
        (
            "held",
            "held over 4 substeps",
            springs::held(4, steps, every),
        ),
        ("held", "held over 2", springs::held(2, steps, every)),
        (
            "held",
            "SemiImplicitEuler",
            springs::by(SemiImplicitEuler, steps, every),
        ),
        ("held", "Verlet", springs::by(Verlet, steps, every)),
    ]
}

fn roundings() -> [Line; 9] {
    use rounding::*;
    let (start, until) = (400, 20);
    [
        ("drag", "exact", exact(start, until)),
        ("drag", "v -= c * v of fixed", naive_drag(start, until)),
        (
            "drag",
            "v -= c * v of fixed from below",
            naive_drag(-start, until),
        ),
        ("drag", "LinearDrag", linear_drag(start, until)),
        ("drag", "ExactDrag", exact_drag(start, until)),
        ("middle", "x += h * v of fixed", naive_middle(60)),
        ("middle", "this crate", crate_middle(60)),
        ("range", "x += h * v of fixed", naive_flight(60)),
        ("range", "this crate", crate_flight(60)),
    ]
}

fn far_away() -> [Line; 10] {
    use far::{FIXED, FLOAT, cruise, exact_fall, fall};
    [
        (
            "cruise",
            "f32 at 100 km at 0.2 m/s",
            cruise::<f32>(FLOAT, 0.2),
        ),
        (
            "cruise",
            "f32 at 100 km at 0.3 m/s",
            cruise::<f32>(FLOAT, 0.3),
        ),
        (
            "cruise",
            "f32 at the origin at 0.2 m/s",
            cruise::<f32>(0.0, 0.2),
        ),
        (
            "cruise",
            "f32 at the origin at 0.3 m/s",
            cruise::<f32>(0.0, 0.3),
        ),
        (
            "cruise",
            "I16F16 at 30 km at 0.2 m/s",
            cruise::<I16F16>(FIXED, 0.2),
        ),
        (
            "cruise",
            "I16F16 at 30 km at 0.3 m/s",
            cruise::<I16F16>(FIXED, 0.3),
        ),
        ("fall", "f32 at 100 km", fall::<f32>(FLOAT)),
        ("fall", "f32 at the origin", fall::<f32>(0.0)),
        ("fall", "I16F16 at 30 km", fall::<I16F16>(FIXED)),
        ("fall", "exact", exact_fall()),
    ]
}

fn clocks() -> [Line; 2] {
    [
        ("clock", "t += 1/60 in f32", clock::added()),
        ("clock", "ticks of this crate", clock::counted()),
    ]
}

/// All of it takes less than a second: a quick run makes the same rows.
pub fn make(_: Effort, progress: &ProgressBar) -> Table {
    progress.inc_length(4);
    let mut lines = vec![];
    for part in [
        || springs().to_vec(),
        || roundings().to_vec(),
        || far_away().to_vec(),
        || clocks().to_vec(),
    ] as [fn() -> Vec<Line>; 4]
    {
        lines.extend(part());
        progress.inc(1);
    }
    let row = |panel: &str, line: &str, [x, y]: [f64; 2]| {
        vec![
            panel.into(),
            line.into(),
            format!("{x:.4}"),
            format!("{y:.4e}"),
        ]
    };
    let rows = lines
        .iter()
        .flat_map(|(panel, line, points)| points.iter().map(move |&point| row(panel, line, point)));
    Table {
        name: "wrong",
        keys: 3,
        header: vec!["panel", "line", "x", "y"],
        rows: rows.collect(),
    }
}

/// The points of a line of the table.
fn points(table: &Table, panel: &str, line: &str) -> Vec<[f64; 2]> {
    let rows = table.rows.iter().filter(|row| row[..2] == [panel, line]);
    let number = |text: &String| text.parse().unwrap_or(f64::NAN);
    rows.map(|row| [number(&row[2]), number(&row[3])]).collect()
}

/// Writes `wrong.png`.
pub fn draw(folder: &Path, table: &Table) -> Drawn {
    picture::draw(&folder.join("wrong.png"), table)
}
