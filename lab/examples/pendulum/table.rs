//! The figures as a table: a row for each amplitude and number type.

use crate::exact;
use crate::runs::Run;

pub const HEAD: &str = "\
| amplitude | numbers | steps/s | exact period, s | measured, s | error | of it rounding | energy drift in 60 s |
|---|---|---|---|---|---|---|---|
";

/// A row for each run; what rounding adds is the difference to the `f64` run of the same rate.
pub fn rows(runs: &[Run]) -> Vec<String> {
    runs.iter().map(row).collect()
}

fn row(run: &Run) -> String {
    let exact = exact::period(f64::from(run.degrees));
    let rounding = match run.numbers {
        "f64" => String::new(),
        _ => figure((run.swing.period - run.smooth) / exact),
    };
    format!(
        "| {}° | {} | {} | {exact:.9} | {:.9} | {} | {rounding} | {} |",
        run.degrees,
        run.numbers,
        run.rate,
        run.swing.period,
        figure(run.error()),
        figure(run.swing.drift),
    )
}

fn figure(value: f64) -> String {
    format!("{value:+.1e}").replace('-', "\u{2212}")
}
