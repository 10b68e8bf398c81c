//! The table of the README: worst ticks over all falls. Methods that made the same bits share a row.

use crate::scene::Law;
use crate::series::{Group, Series, coinciding};

pub const HEAD: &str = "\
| method | scalar | linear, median | linear, max | quadratic, median | quadratic, max |
|---|---|---|---|---|---|
";

/// A row for each scalar and group of methods.
pub fn rows(all: &[Series]) -> Vec<String> {
    coinciding(all).iter().map(row).collect()
}

fn row(group: &Group) -> String {
    let [linear, quadratic] = Law::BOTH.map(|law| group.series.worst(law));
    let figures = [linear, quadratic]
        .concat()
        .into_iter()
        .map(|error| format!("{error:.1e}"));
    let figures: Vec<String> = figures.map(padded).collect();
    let (method, scalar) = (group.label(), &group.series.scalar);
    format!("| {method} | {scalar} | {} |", figures.join(" | "))
}

/// With two digits of exponent, as the other tables have it.
fn padded(figure: String) -> String {
    match figure.split_once("e-") {
        Some((digits, exponent)) => format!("{digits}e-{exponent:0>2}"),
        None => figure,
    }
}
