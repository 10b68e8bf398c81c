//! The map of `ω h` and damping ratio: closed form, matrix and run say the same in every cell.

use crate::stability::law::{DRAGS, Drag, LAWS, Law, radius, stable};
use crate::stability::run::*;
use crate::stability::scene::*;

pub const ZETAS: [f64; 7] = [0.0, 0.01, 0.1, 0.5, 1.0, 2.0, 5.0];

/// The step in `f64` has the trace and the determinant of the closed form. Both are compared by the
/// size of the terms that cancel in them: the entries of a step are at most `(1 + q + g)^kicks`.
fn check_matrix(law: &Law, swing: Swing) -> bool {
    let matrix = swing.matrix(law.scheme);
    let size = matrix
        .as_flattened()
        .iter()
        .fold(1.0, |a: f64, b| a.max(b.abs()));
    let [trace, det] = measured(matrix);
    let closed = (law.spring)(swing.drag, swing.q, swing.zeta);
    let errors = [
        (trace - closed[0]).abs() / size,
        (det - closed[1]).abs() / (size * size),
    ];
    let what = format!("{:?} {swing:?}: {errors:?}", law.scheme);
    assert!(errors.iter().all(|&error| error <= SLACK), "{what}");
    holds([trace, det])
}

/// What grows in fixed point comes to the end of the range. Within ten times the steps that its growth
/// needs, as clamped swings stay inside for a while, the world tells of it, if it can.
fn check_end<S: Number>(law: &Law, swing: Swing) {
    let growth = radius((law.spring)(swing.drag, swing.q, swing.zeta)).ln();
    let patience = 10.0 * 4096.0_f64.ln() / growth;
    let Run { told, far, .. } = run::<S>(law, swing, patience as u32 + STEPS);
    let held = told || (clamped_inside(law, swing) && far);
    assert!(held, "{} {:?} {swing:?}: never told", S::name(), law.scheme);
}

/// Whether a run stays bounded; one in fixed point that does not is followed to the end of the range.
fn runs_on<S: Number>(law: &Law, swing: Swing) -> bool {
    let bounded = bounded::<S>(law, swing);
    if !bounded && !is_float::<S>() {
        check_end::<S>(law, swing);
    }
    bounded
}

/// A row of the map, `.` for stable and `#` for not.
fn row(stable: impl Fn(Swing) -> bool, drag: Drag, zeta: f64) -> String {
    let cell = |i| {
        let q = column(i);
        if stable(Swing { drag, q, zeta }) {
            '.'
        } else {
            '#'
        }
    };
    (0..COLUMNS).map(cell).collect()
}

/// The closed form and the matrix and the runs change in the same cells.
fn check_row<S: Number>(law: &Law, drag: Drag, zeta: f64) {
    let closed = row(|s| stable((law.spring)(drag, s.q, zeta)), drag, zeta);
    let matrix = row(|s| check_matrix(law, s), drag, zeta);
    let runs = row(|s| runs_on::<S>(law, s), drag, zeta);
    let what = format!("{:?}, {drag:?} drag, damping ratio {zeta}", law.scheme);
    assert_eq!(matrix, closed, "{what}: matrix");
    assert_eq!(runs, closed, "{what}: {}", S::name());
}

pub fn check_map<S: Number>() {
    for law in &LAWS {
        for (drag, zeta) in DRAGS
            .into_iter()
            .flat_map(|drag| ZETAS.map(|zeta| (drag, zeta)))
        {
            check_row::<S>(law, drag, zeta);
        }
    }
}

/// The table: rows of the map with their limits. Measured and closed differ by what `SLACK` moves them:
/// where the determinant is 1 + q² or 1 + q²/2, by the root of twice of it, 3e-6; elsewhere by less, as
/// both conditions change by 0.01 or more for a unit of q.
pub fn print_map() {
    println!(
        "{:<24}{:<10}{:<6}{:<34}{:>9}{:>9}",
        "method", "drag", "zeta", "w h = 0.05 to 6", "measured", "closed"
    );
    for law in &LAWS {
        for (drag, zeta) in DRAGS
            .into_iter()
            .flat_map(|drag| ZETAS.map(|zeta| (drag, zeta)))
        {
            let row = row(|s| check_matrix(law, s), drag, zeta);
            let (measured, closed) = (measured_limit(law, drag, zeta), law.limit(drag, zeta));
            println!(
                "{:<24}{:<10}{zeta:<6}{row:<34}{measured:>9.4}{closed:>9.4}",
                format!("{:?}", law.scheme),
                format!("{drag:?}")
            );
            let same = measured == closed || (measured - closed).abs() <= 1e-5;
            assert!(
                same,
                "{:?} {drag:?} {zeta}: {measured} and {closed}",
                law.scheme
            );
        }
    }
}
