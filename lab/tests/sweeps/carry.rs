//! Bodies that keep what their roundings leave over: what they lose in a million steps.

use crate::support;

#[path = "../../../tests/suite/carry/bits.rs"]
mod bits;
#[path = "carry/cruise.rs"]
mod cruise;
#[path = "../../../tests/suite/carry/exchange.rs"]
mod exchange;
#[path = "../../../tests/suite/carry/fall.rs"]
mod fall;
#[path = "../../../tests/suite/carry/floats.rs"]
mod floats;
#[path = "../../../tests/suite/carry/flows.rs"]
mod flows;
#[path = "../../../tests/suite/carry/momentum.rs"]
mod momentum;
#[path = "../../../tests/suite/carry/range.rs"]
mod range;
#[path = "carry/spring.rs"]
mod spring;
#[path = "../../../tests/suite/carry/symmetry.rs"]
mod symmetry;
#[path = "../../../tests/suite/carry/verbs.rs"]
mod verbs;

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
