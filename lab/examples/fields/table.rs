//! The table on the terminal: where each method ends, and how far off it was on the way.

use std::fmt::Write;

use crate::figures::{Group, START, V0, coinciding};
use crate::flight::{Run, Sample};

/// Both figures; methods that make the same points share a line.
pub fn report(fig1: &[Run], fig2: &[Run]) -> String {
    let [x, y] = START;
    let mut text = format!(
        "Fig. 1: dy/dx = 2x from ({x}, {y}){}\n",
        goal("x", "", fig1)
    );
    text.push_str(&head("y"));
    text.push_str(&lines(fig1));
    let _ = writeln!(
        text,
        "\nFig. 2: dv/dt = -k v/m, k = 1 kg/s, m = 1 kg, from {V0} m/s{}",
        goal("t", " s", fig2)
    );
    text.push_str(&head("v, m/s"));
    text.push_str(&lines(fig2));
    text
}

fn goal(name: &str, unit: &str, runs: &[Run]) -> String {
    let end = runs.first().and_then(|run| run.samples.last());
    end.map_or_else(String::new, |end| format!(" to {name} = {}{unit}", end.at))
}

fn head(value: &str) -> String {
    layout([
        "method",
        "step",
        value,
        "exact",
        "error",
        "largest on the way",
    ])
}

fn lines(runs: &[Run]) -> String {
    let line = |group: Group| {
        let samples = &group.run.samples;
        let end = samples.last()?;
        Some(layout([
            &group.label(),
            &group.run.step.to_string(),
            &figure(end.value),
            &figure(end.exact),
            &figure(end.error()),
            &figure(largest(samples)),
        ]))
    };
    coinciding(runs).into_iter().filter_map(line).collect()
}

/// The error that is farthest from zero, with its sign.
fn largest(samples: &[Sample]) -> f64 {
    let errors = samples.iter().map(Sample::error);
    let farthest = errors.max_by(|a, b| a.abs().total_cmp(&b.abs()));
    farthest.unwrap_or(0.0)
}

fn figure(value: f64) -> String {
    if value == 0.0 {
        return "0".to_string();
    }
    format!("{value:.4}")
}

fn layout([method, step, value, exact, error, largest]: [&str; 6]) -> String {
    format!("  {method:<31}  {step:>4}  {value:>9}  {exact:>9}  {error:>9}  {largest:>18}\n")
}
