//! Bodies that keep what their roundings leave over: what they lose in a million steps, what a push
//! exchanges, and the laws that a point keeps.

use crate::support;

#[path = "carry/bits.rs"]
mod bits;
#[path = "carry/cruise.rs"]
mod cruise;
#[path = "carry/exchange.rs"]
mod exchange;
#[path = "carry/fall.rs"]
mod fall;
#[path = "carry/floats.rs"]
mod floats;
#[path = "carry/flows.rs"]
mod flows;
#[path = "carry/momentum.rs"]
mod momentum;
#[path = "carry/range.rs"]
mod range;
#[path = "carry/spring.rs"]
mod spring;
#[path = "carry/symmetry.rs"]
mod symmetry;
#[path = "carry/verbs.rs"]
mod verbs;

/// Median and maximum of the errors of a body, in two columns of the README's table of long runs.
fn told(body: &str, column: usize, errors: &[f64]) {
    let readme = include_str!("../../README.md");
    let table = readme.split("### Long runs").nth(1).unwrap();
    let row = table
        .lines()
        .find(|line| line.starts_with(&format!("| `{body}` |")));
    let cells: Vec<_> = row.unwrap_or_else(|| panic!("{body}")).split('|').collect();
    let figures = [support::median(errors), support::maximum(errors)];
    for (cell, figure) in cells[column..].iter().zip(figures) {
        assert_eq!(cell.trim(), format!("{figure:.1e}"), "{body}");
    }
}
