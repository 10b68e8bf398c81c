//! Bodies that keep what their roundings leave over: what they lose in a million steps.

use crate::support;

#[path = "../../../tests/suite/carry/bits.rs"]
#[allow(dead_code, reason = "the quick suite uses the others")]
mod bits;
#[path = "carry/cruise.rs"]
mod cruise;
#[path = "../../../tests/suite/carry/momentum.rs"]
mod momentum;
#[path = "carry/spring.rs"]
mod spring;

/// Median and maximum of the errors of a body, in two columns of the table of long runs.
fn told(body: &str, column: usize, errors: &[f64]) {
    let table = support::pages::pages()
        .split("### Long runs")
        .nth(1)
        .unwrap();
    let row = table
        .lines()
        .find(|line| line.starts_with(&format!("| `{body}` |")));
    let cells: Vec<_> = row.unwrap_or_else(|| panic!("{body}")).split('|').collect();
    let figures = [support::median(errors), support::maximum(errors)];
    for (cell, figure) in cells[column..].iter().zip(figures) {
        assert_eq!(cell.trim(), format!("{figure:.1e}"), "{body}");
    }
}
