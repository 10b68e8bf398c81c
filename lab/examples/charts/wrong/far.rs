//! The same motion near the origin and far from it: `f32` at 10^5 m, `I16F16` at 30 km.
//!
//! From 2^16 to 2^17 m the values of `f32` lie 2^-7 m apart. A drift of less than half of that is nothing,
//! more is at least all of it. At 60 Hz a body at 0.2 m/s stands still, and one at 0.3 m/s runs at `2^-7 60
//! / 0.3` = 156 %. At 600 Hz a fall moves when `g h² n` reaches 2^-8 m, after 143.4 steps.

use fixstep::{Force, GravityY, SemiImplicitEuler, Step, World, dec};

use crate::support::*;

/// m.
pub const FLOAT: f64 = 1e5;
pub const FIXED: f64 = 3e4;

/// `[seconds, m]` from the start, each `every` steps of `hz`.
fn paths<S: Format>(
    [start, speed]: [f64; 2],
    mut force: impl Force<fixstep::Point<S>>,
    [hz, steps, every]: [u32; 3],
) -> Vec<[f64; 2]> {
    let mut world: World<_, 1> = world([point::<S>([0.0, start], [0.0, speed], 1.0)]);
    let step = Step::hz(ratio(f64::from(hz))).unwrap();
    let mut found = vec![[0.0; 2]];
    for n in 1..=steps {
        world.step(&mut SemiImplicitEuler, &mut force, &step);
        if n.is_multiple_of(every) {
            let moved = world.bodies()[0].position().y.to_f64() - start;
            found.push([f64::from(n) / f64::from(hz), moved]);
        }
    }
    found
}

/// Ten seconds at a speed.
pub fn cruise<S: Format>(start: f64, speed: f64) -> Vec<[f64; 2]> {
    paths::<S>([start, speed], (), [60, 600, 30])
}

/// Half a second of falling from rest at 600 Hz.
pub fn fall<S: Format>(start: f64) -> Vec<[f64; 2]> {
    let gravity = GravityY::<S>::new(dec!(-9.81)).unwrap();
    paths::<S>([start, 0.0], gravity, [600, 300, 6])
}

/// The same in exact arithmetic, by the same method: `-g h² n (n + 1) / 2`.
pub fn exact_fall() -> Vec<[f64; 2]> {
    let at = |n: f64| [n / 600.0, -9.81 / 360_000.0 * n * (n + 1.0) / 2.0];
    (0..=50).map(|i| at(6.0 * f64::from(i))).collect()
}
