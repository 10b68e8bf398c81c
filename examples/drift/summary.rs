//! What a run says first: one screen with a line for each scene, and a conclusion.

use std::fmt::Write;

use crate::cli::{MethodName, Options, ScalarName, name};
use crate::compare::Row;
use crate::scene::{STARTS, Scene};
use crate::table::figure;
use crate::work::Case;

/// The method that the crate recommends to start with.
const METHOD: MethodName = MethodName::Verlet;
/// The types of 32 bits, of which one is the best.
const WORDS: [ScalarName; 5] = [
    ScalarName::F32,
    ScalarName::I8F24,
    ScalarName::I12F20,
    ScalarName::I16F16,
    ScalarName::I20F12,
];
/// The types whose errors are shown.
const SHOWN: [ScalarName; 3] = [ScalarName::F32, ScalarName::I16F16, ScalarName::I8F24];

/// A part of an error, by its name.
pub fn dominant(row: &Row) -> &'static str {
    let parts = [
        ("method", row.method),
        ("coefficients", row.coefficient),
        ("rounding", row.rounding),
    ];
    let largest = parts.into_iter().max_by(|a, b| a.1.total_cmp(&b.1));
    match largest {
        Some((name, part)) if part > 0.0 => name,
        _ => "none",
    }
}

/// The last row of a scene in one type, if its bodies stayed in the range.
fn end<'a>(cases: &'a [Case], scene: &Scene, scalar: ScalarName) -> Option<&'a Row> {
    let mut cases = cases.iter();
    let case = cases.find(|case| {
        case.scene.name == scene.name && case.method == METHOD && case.scalar == scalar
    })?;
    let row = case.rows.as_ref().ok()?.last()?;
    row.error.is_finite().then_some(row)
}

/// The type of 32 bits that adds the least to the error of the method; of equal ones the first.
fn best<'a>(cases: &'a [Case], scene: &Scene) -> Option<(ScalarName, &'a Row)> {
    let rows = WORDS.map(|scalar| Some((scalar, end(cases, scene, scalar)?)));
    let rows = rows.into_iter().flatten();
    rows.min_by(|a, b| a.1.scalar.total_cmp(&b.1.scalar))
}

/// The screen, but for what was written where.
pub fn report(options: &Options, cases: &[Case]) -> String {
    let mut text = format!(
        "Error of {} at {} steps a second against the exact solution, in metres:\n\
         median of {STARTS} starts at the end of a scene. 'best' is the 32-bit type that adds\n\
         least to the method's error; 'largest part' is that of its error.\n\
         'range': the scene does not fit the type.\n\n",
        name(METHOD),
        options.hz.to_f64(),
    );
    let _ = writeln!(
        text,
        "{:<15} {:>8} {:>9} {:>9} {:>9}   largest part",
        "scene", "best", "f32", "I16F16", "I8F24"
    );
    let (mut firsts, mut causes) = ([0; WORDS.len()], Vec::new());
    for &scene in &options.scene {
        let found = best(cases, scene);
        let (winner, cause) = found.map_or(("-".into(), "-"), |(scalar, row)| {
            firsts[WORDS.iter().position(|&word| word == scalar).unwrap_or(0)] += 1;
            (name(scalar), dominant(row))
        });
        let errors = SHOWN.map(|scalar| match end(cases, scene, scalar) {
            Some(row) => figure(row.error),
            None => "range".into(),
        });
        let [f32, wide, narrow] = &errors;
        let _ = writeln!(
            text,
            "{:<15} {winner:>8} {f32:>9} {wide:>9} {narrow:>9}   {cause}",
            scene.name
        );
        causes.push(cause);
    }
    text + &conclusion(&firsts, &causes)
}

/// Who is best how often, and what to change where which part is the largest.
fn conclusion(firsts: &[usize; WORDS.len()], causes: &[&str]) -> String {
    let count = |cause| causes.iter().filter(|&&other| other == cause).count();
    let mut order: Vec<_> = WORDS.iter().zip(firsts).filter(|(_, n)| **n > 0).collect();
    order.sort_by_key(|(_, n)| usize::MAX - **n);
    let wins = order
        .iter()
        .map(|(scalar, n)| format!("{} in {n}", name(**scalar)));
    format!(
        "\nBest type: {} (of {} scenes).\n\
         Where the method is the largest part ({} scenes), raise the rate or the order.\n\
         Where the coefficients are ({}), take another type.\n\
         Where rounding is ({}), take a finer type or a `Carried` body.\n",
        wins.collect::<Vec<_>>().join(", "),
        causes.len(),
        count("method"),
        count("coefficients"),
        count("rounding"),
    )
}
