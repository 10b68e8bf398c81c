//! Tables as text: what is the same, what is different, and what a row keeps.

use crate::figures::{HEADER, KEYS, Row};
use crate::table::{Effort, Table};

fn table(rows: &[[&str; 3]]) -> Table {
    let row = |cells: &[&str; 3]| cells.map(String::from).to_vec();
    Table {
        name: "some",
        keys: 2,
        header: vec!["scene", "rate", "error"],
        rows: rows.iter().map(row).collect(),
    }
}

fn differences(fresh: &[[&str; 3]], committed: &[[&str; 3]], effort: Effort) -> Vec<String> {
    table(fresh).differences(&table(committed).rows, effort)
}

#[test]
fn a_table_reads_its_own_text() {
    let some = table(&[["spring", "60", "1.0e-3"], ["spring", "120", "inf"]]);
    assert_eq!(
        some.csv(),
        "scene,rate,error\nspring,60,1.0e-3\nspring,120,inf\n"
    );
    assert_eq!(some.read(&some.csv()), Ok(some.rows.clone()));
    assert!(some.read("scene,rate\n").is_err());
    assert!(some.read("scene,rate,error\nspring,60\n").is_err());
}

#[test]
fn figures_may_differ_by_one_in_the_last_digit() {
    let same =
        |is, was| differences(&[["a", "1", is]], &[["a", "1", was]], Effort::Full).is_empty();
    assert!(same("1.2345e-3", "1.2345e-3") && same("inf", "inf") && same("text", "text"));
    assert!(
        same("1.2345e-3", "1.2346e-3") && same("9.9999e-4", "1.0000e-3") && same("41.7", "41.8")
    );
    assert!(same("3.1e-16", "9.9e-16"), "below the floor");
    assert!(!same("1.2345e-3", "1.2347e-3") && !same("1.2345e-3", "1.2345e-4"));
    assert!(!same("41.7", "41.9") && !same("3", "5") && !same("text", "another"));
    assert!(!same("inf", "1.0e3") && !same("NaN", "1.0e3") && !same("1.0e3", "NaN"));
}

#[test]
fn a_difference_names_its_row() {
    let old = [["a", "1", "2.0"], ["a", "2", "4.0"]];
    assert_eq!(
        differences(&[["a", "1", "2.0"], ["a", "2", "9.0"]], &old, Effort::Full),
        ["some, row a 2: error is 9.0, committed 4.0"]
    );
    let unknown = [["a", "1", "2.0"], ["a", "2", "4.0"], ["b", "2", "4.0"]];
    let found = differences(&unknown, &old, Effort::Full);
    assert_eq!(found, ["some, row b 2: not in the committed file"]);
    let few = [["a", "1", "2.0"]];
    assert_eq!(differences(&few, &old, Effort::Quick), [""; 0]);
    assert_eq!(
        differences(&few, &old, Effort::Full),
        ["some, row a 2: is made no more"]
    );
}

// Of 21 errors 0 to 20 the quantiles are 1, 10 and 19, whatever their order.
#[test]
fn a_row_keeps_quantiles_and_failures() {
    let mut errors: Vec<f64> = (0..21).rev().map(f64::from).collect();
    let of = |errors: &[f64]| Row::of(["Verlet", "Pull", "f32"], 60, [1.5, 2.0], errors, 17.5);
    let row = of(&errors);
    assert_eq!((row.errors, row.failed), ([1.0, 10.0, 19.0], 3));
    errors[20] = -f64::NAN; // was 0; with that sign, as processors make them, it sorts below all
    errors[19] = f64::INFINITY; // was 1
    let row = of(&errors);
    assert_eq!((row.errors, row.failed), ([3.0, 12.0, f64::INFINITY], 5));
    let some = Table {
        name: "some",
        keys: KEYS,
        header: HEADER.to_vec(),
        rows: vec![row.cells()],
    };
    assert_eq!(Row::all(&some), Ok(vec![row]));
}
