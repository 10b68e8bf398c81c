//! A cell of the map of springs, as it is measured: by a run, and by the matrix of a step.

use fixstep::{Point, World};

use super::law::{Drag, Law, first_root};
use super::scene::*;
use crate::support::*;

/// Steps of a run.
pub const STEPS: u32 = 10_000;
pub const COLUMNS: usize = 32;
/// `ω h` of a column: 0.05 to 6, each 1.167 times the one before.
pub fn column(i: usize) -> f64 {
    0.05 * 120.0_f64.powf(i as f64 / (COLUMNS - 1) as f64)
}

pub fn columns() -> impl Iterator<Item = f64> {
    (0..COLUMNS).map(column)
}

/// Rounding of a step in `f64`: at most twenty roundings on the way, of terms below 1000.
pub const SLACK: f64 = 20.0 * 1000.0 * f64::EPSILON;

/// Whether a step of that trace and determinant is stable, but for rounding.
pub fn holds([trace, det]: [f64; 2]) -> bool {
    trace.abs() <= 1.0 + det + SLACK && det <= 1.0 + SLACK
}

/// The limit of the measured step, from its matrix alone.
pub fn measured_limit(law: &Law, drag: Drag, zeta: f64) -> f64 {
    let step = |q| measured(Swing { drag, q, zeta }.matrix(law.scheme));
    first_root(|q| holds(step(q)), 6.0)
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
pub struct Run {
    /// The world told of it.
    pub told: bool,
    /// It came to 128 times its start in (x, u): no stable swing of the map is stretched as much.
    pub far: bool,
    /// How large (x, u) was in the first and in the second half.
    pub halves: [f64; 2],
}

/// Makes `steps`, fewer where the world tells of the end of the range; where a damped swing or a float
/// is far; or where both starts have shrunk a thousandfold, which makes so many steps together a
/// contraction. Positions saturate: none moves by more than two steps of the largest velocity, as it
/// would if it came out at the other end.
pub fn run<S: Number>(law: &Law, swing: Swing, steps: u32) -> Run {
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
pub fn bounded<S: Number>(law: &Law, swing: Swing) -> bool {
    let Run { told, far, halves } = run::<S>(law, swing, STEPS);
    !told && !far && halves[1] <= 1.25 * halves[0]
}

/// Whether a swing in fixed point can be clamped within a step and end it inside the range, for ever:
/// what one kick has clamped, a drag or another kick takes back.
pub fn clamped_inside(law: &Law, swing: Swing) -> bool {
    swing.zeta > 0.0 || law.calls > 1
}
