//! One fall through [`World::step`], and how far its speed then is from the terminal speed.
//!
//! A fall gets `36 / q` ticks to settle, which leaves `(1 - q)^n < e^-36 = 2.3e-16` of the way, and
//! is watched for `20 / q` more. No force reads the position: it may run to the end of the range.

use fixstep::{GravityY, LinearDrag, QuadraticDrag, Step};

use crate::scene::{Fall, Law, RATE};
use crate::support::{Format, Scheme, point, ratio, world};

/// What is left of the way after settling, relatively: `e^-SETTLED`.
pub const SETTLED: f64 = 36.0;
/// How long it is watched, in the same units.
pub const WATCHED: f64 = 20.0;

/// Distances from the terminal speed, relatively, while watched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// Of the mean velocity.
    pub mean: f64,
    /// Of the velocity at the worst tick.
    pub worst: f64,
    /// A hash of every velocity since the start: two methods with the same one made the same bits.
    pub path: u64,
}

/// Ticks to settle, and ticks to watch.
pub fn ticks(fall: &Fall) -> [u32; 2] {
    [SETTLED, WATCHED].map(|times| (times / fall.share()).ceil() as u32)
}

/// Settles from `from` times the terminal speed and watches.
pub fn outcome<S: Format>(scheme: Scheme, fall: &Fall, from: f64) -> Outcome {
    let (exact, [settle, watch]) = (fall.speed(), ticks(fall));
    let (mut sum, mut worst, mut path) = (0.0, 0.0_f64, 0_u64);
    descend::<S>(scheme, fall, from * exact, settle + watch, |tick, speed| {
        path = (path.rotate_left(5) ^ speed.to_bits()).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        if tick > settle {
            // Differences, not speeds: their sum rounds less.
            let off = speed - exact;
            sum += off;
            worst = if off.abs() <= worst { worst } else { off.abs() };
        }
    });
    let mean = (sum / f64::from(watch)).abs();
    Outcome {
        mean: mean / exact,
        worst: worst / exact,
        path,
    }
}

/// Falls from a speed; `see` gets every tick, from 1, and the speed after it, m/s.
pub fn descend<S: Format>(
    scheme: Scheme,
    fall: &Fall,
    start: f64,
    ticks: u32,
    mut see: impl FnMut(u32, f64),
) {
    let body = point::<S>([0.0, 0.0], [0.0, -start], fall.mass);
    let mut world = world::<_, 1>([body]);
    let mut method = scheme.method();
    let drag = ratio(fall.drag);
    let mut forces = (
        GravityY::new(ratio(-fall.gravity)).unwrap(),
        (fall.law == Law::Linear).then(|| LinearDrag::new(drag).unwrap()),
        (fall.law == Law::Quadratic).then(|| QuadraticDrag::new(drag).unwrap()),
    );
    let step = Step::hz(RATE as i32).unwrap();
    for tick in 1..=ticks {
        world.step(&mut method, &mut forces, &step);
        see(tick, -world.bodies()[0].velocity().to_f64().y);
    }
}
