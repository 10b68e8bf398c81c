//! Why floats are refused: turned round, they end elsewhere.

use super::gravity::{bodies, pull};
use super::*;
use crate::support::{median, world};

/// The scene of `gravity.rs` in `f32`, 10^4 steps out and 10^4 back by hand: the largest distance of
/// a body from where it began.
fn distance(start: u64) -> f64 {
    let step = Step::<f32>::hz(60).unwrap();
    let mut world = world(bodies::<f32>(start));
    let (began, mut pull) = (world.clone(), pull());
    for _ in 0..2 {
        (0..10_000).for_each(|_| world.step(&mut Verlet, &mut pull, &step));
        for (_, body) in world.iter_mut() {
            body.set_velocity(-body.velocity()).unwrap();
        }
    }
    let pairs = world.bodies().iter().zip(began.bodies());
    let away = pairs.map(|(end, start)| (end.position() - start.position()).to_f64().length());
    away.fold(0.0, f64::max)
}

#[test]
fn f32_does_not_return() {
    let mut away: Vec<_> = (1..=16).map(distance).collect();
    away.sort_by(f64::total_cmp);
    println!(
        "f32, 10^4 steps and back: off by {:.1e} m at least, {:.1e} in the median, {:.1e} at most",
        away[0],
        median(&away),
        away[15]
    );
    // The median is a thousand units of an f32 at 4 m and more.
    assert!(away[0] > 0.0 && median(&away) > 1000.0 * 2.0_f64.powi(-21));
}
