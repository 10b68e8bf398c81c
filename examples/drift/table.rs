//! The table on the terminal: one block a scene, one line a method and scalar.

use std::fmt::Write;

use crate::cli::{Options, name};
use crate::compare::Row;
use crate::scene::{Kept, STARTS, Scene};
use crate::work::{Case, marks};

/// The whole report.
pub fn report(options: &Options, cases: &[Case]) -> String {
    let mut text = preface(options);
    for &scene in &options.scene {
        let _ = write!(text, "\n{}\n{}\n", scene.title, head(options, scene));
        for case in cases.iter().filter(|case| case.scene.name == scene.name) {
            text.push_str(&line(case));
            text.push('\n');
        }
    }
    text
}

fn preface(options: &Options) -> String {
    format!(
        "Position error against the exact solution, in metres, at {} steps per second.\n\
         Each figure is the median of {STARTS} start values; 'worst' is the largest error of any.\n\
         At the end: worst, and the parts of method, of coefficients and of rounding the state;\n\
         energy as change over its first value, momentum in kg m/s ('-' where it is not kept).\n\
         'out': a body left the range of the scalar, or became infinite or no number.\n",
        options.hz.to_f64()
    )
}

fn head(options: &Options, scene: &Scene) -> String {
    let steps = scene.steps(options.hz, options.seconds);
    let times = marks(steps).map(|tick| time(tick as f64 / options.hz.to_f64()));
    let [a, b, c, d] = times;
    let labels = ["scene", "method", "scalar", "bytes"];
    let figures = [
        &a, &b, &c, &d, "worst", "method", "coeff", "rounding", "energy", "momentum",
    ];
    layout(labels, figures)
}

fn line(case: &Case) -> String {
    let (method, scalar) = (name(case.method), name(case.scalar));
    let bytes = case.bytes_per_body.to_string();
    let labels = [case.scene.name, &method, &scalar, &bytes];
    match &case.rows {
        Ok(rows) => figures(labels, rows, case.scene.kept),
        Err(error) => format!("{}  - {error}", layout(labels, [""; 0])),
    }
}

fn figures(labels: [&str; 4], rows: &[Row], kept: Kept) -> String {
    let Some(end) = rows.last() else {
        return layout(labels, [""; 0]);
    };
    let marks = marks(end.tick);
    let at = |tick| {
        rows.iter()
            .find(|row| row.tick == tick)
            .map_or(f64::INFINITY, |row| row.error)
    };
    let if_kept = |kept: bool, value| if kept { figure(value) } else { "-".to_string() };
    let mut cells: Vec<String> = marks.map(|tick| figure(at(tick))).to_vec();
    let parts = [end.worst, end.method, end.coefficient, end.rounding];
    cells.extend(parts.map(figure));
    cells.push(if_kept(kept.energy, end.energy));
    cells.push(if_kept(kept.momentum, end.momentum));
    layout(labels, cells)
}

fn layout<T: AsRef<str>>(labels: [&str; 4], figures: impl IntoIterator<Item = T>) -> String {
    let [scene, method, scalar, bytes] = labels;
    let mut line = format!("{scene:<14}  {method:<21}  {scalar:<6}  {bytes:>5}");
    for figure in figures {
        let _ = write!(line, "  {:>8}", figure.as_ref());
    }
    line
}

/// Two digits; 'out' for what is not finite.
pub fn figure(value: f64) -> String {
    match value {
        0.0 => "0".to_string(),
        value if value.is_finite() => format!("{value:.1e}"),
        _ => "out".to_string(),
    }
}

/// In the unit that suits.
fn time(seconds: f64) -> String {
    let (value, unit) = match seconds {
        ..0.1 => (seconds * 1000.0, "ms"),
        ..100.0 => (seconds, "s"),
        ..6000.0 => (seconds / 60.0, "min"),
        _ => (seconds / 3600.0, "h"),
    };
    let digits = if value < 10.0 { 2 } else { 1 };
    let text = format!("{value:.digits$}");
    format!(
        "{} {unit}",
        text.trim_end_matches('0').trim_end_matches('.')
    )
}
