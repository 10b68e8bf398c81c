//! The map of `ω h` and damping ratio: closed form, matrix and run say the same in every cell.

use fixstep::{Point, World};

use crate::law::{DRAGS, Drag, LAWS, Law, first_root, radius, stable};
use crate::scene::*;
use crate::support::*;

pub const ZETAS: [f64; 7] = [0.0, 0.01, 0.1, 0.5, 1.0, 2.0, 5.0];
const COLUMNS: usize = 32;
/// Steps of a run.
const STEPS: u32 = 10_000;

/// `ω h` of a column: 0.05 to 6, each 1.167 times the one before.
fn column(i: usize) -> f64 {
    0.05 * 120.0_f64.powf(i as f64 / (COLUMNS - 1) as f64)
}

pub fn columns() -> impl Iterator<Item = f64> {
    (0..COLUMNS).map(column)
}

/// Rounding of a step in `f64`: at most twenty roundings on the way, of terms below 1000.
const SLACK: f64 = 20.0 * 1000.0 * f64::EPSILON;

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
    trace.abs() <= 1.0 + det + SLACK && det <= 1.0 + SLACK
}

/// Of a start in (x, u): 1/2048 of the range, in x or in v.
fn size<S: Number>(swing: Swing) -> f64 {
    reach::<S>() / 2048.0 / swing.omega().max(1.0)
}

/// One body, whose axes start on the axes of the phase plane.
fn start<S: Number>(swing: Swing) -> World<Point<S>, 1> {
    let size = size::<S>(swing);
    swing.world([[[size, 0.0], [0.0, size]]])
}

/// What a run came to.
struct Run {
    /// The world told of it.
    told: bool,
    /// It came to 128 times its start in (x, u): no stable swing of the map is stretched as much.
    far: bool,
    /// How large (x, u) was in the first and in the second half.
    halves: [f64; 2],
}

/// Makes `steps`, fewer where the world tells of the end of the range; where a damped swing or a float
/// is far; or where both starts have shrunk a thousandfold, which makes so many steps together a
/// contraction. Positions saturate: none moves by more than two steps of the largest velocity, as it
/// would if it came out at the other end.
fn run<S: Number>(law: &Law, swing: Swing, steps: u32) -> Run {
    let mut world = start::<S>(swing);
    let mut forces = swing.forces(&world);
    let (mut method, step) = (law.scheme.method(), step());
    let (start, stride) = (size::<S>(swing), 2.0 * S::MAX.to_f64() / RATE);
    let mut run = Run {
        told: false,
        far: false,
        halves: [0.0; 2],
    };
    let mut before = state(&world.bodies()[0]).0;
    for tick in 0..steps {
        world.step(&mut method, &mut forces, &step);
        let (x, v) = state(&world.bodies()[0]);
        if world.out_of_range().count() > 0 {
            return Run { told: true, ..run };
        }
        let moved = (x[0] - before[0]).abs().max((x[1] - before[1]).abs());
        assert!(moved <= stride, "{} {:?} {swing:?}", S::name(), law.scheme);
        before = x;
        let [x, v] = [x, v].map(|axes| maximum(&axes.map(f64::abs)));
        let size = maximum(&[x, v / swing.omega()]);
        run.far |= size >= 128.0 * start;
        let half = &mut run.halves[(2 * tick / steps) as usize];
        *half = maximum(&[*half, size]);
        let enough = run.far && (is_float::<S>() || clamped_inside(law, swing));
        if enough || size <= 1e-3 * start {
            break;
        }
    }
    run
}

/// Whether a run stays bounded: neither at the end of the range nor far from its start, and in the
/// second half of 10,000 steps no larger than 1.25 times what it was in the first. The slowest growth
/// in the map is 1.25e-4 a step (constant acceleration, q = 0.05, ζ = 0.01): 1.9 times in half of them.
/// What is bounded and does not shrink swings for at least 40 turns in either half, and rounding moves
/// it by a fortieth at most: 1e4 steps of ten roundings are six deviations of 550 units, on 2e4 units
/// in the shortest swing.
fn bounded<S: Number>(law: &Law, swing: Swing) -> bool {
    let Run {
        told,
        far,
        halves: [first, second],
    } = run::<S>(law, swing, STEPS);
    let bounded = !told && !far && second <= 1.25 * first;
    if !bounded && !told && !is_float::<S>() {
        check_end::<S>(law, swing);
    }
    bounded
}

/// Whether a swing in fixed point can be clamped within a step and end it inside the range, for ever:
/// what one kick has clamped, a drag or another kick takes back.
fn clamped_inside(law: &Law, swing: Swing) -> bool {
    swing.zeta > 0.0 || law.calls > 1
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
    let runs = row(|s| bounded::<S>(law, s), drag, zeta);
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

/// The limit of the measured step, from its matrix alone.
fn measured_limit(law: &Law, drag: Drag, zeta: f64) -> f64 {
    first_root(|q| check_matrix(law, Swing { drag, q, zeta }), 6.0)
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
