//! What explicit drag leaves moving for ever, and exact drag does not.

use super::RATE;
use crate::support::*;
use fixstep::fixed::types::{I8F24, I12F20, I16F16};
use fixstep::{Decay, ExactDrag, Force, LinearDrag, Point, Step};

/// Units of the speed that is left after `steps`, of each of sixteen starts.
fn left<S: Grid + Decay>(mut drag: impl Force<Point<S>>, steps: u32) -> [i32; 16] {
    let starts: [f64; 16] =
        std::array::from_fn(|i| (2.0 + 100.0 * spread(i)) * (1.0 - 2.0 * (i % 2) as f64));
    let mut world = world(starts.map(|v| point::<S>([0.0; 2], [v, 0.0], 1.0)));
    let step = Step::hz(RATE as i32).unwrap();
    for _ in 0..steps {
        world.step(&mut fixstep::SemiImplicitEuler, &mut drag, &step);
    }
    std::array::from_fn(|i| world.bodies()[i].velocity().x.units())
}

/// The explicit kick of `x v` rounds to nothing below half a unit: from above, v stops at the largest
/// whole number below `1/(2 x)`. No whole number is near `1/(2 x)`, so that is its floor.
fn check<S: Grid + Decay>() {
    let mut off = vec![];
    for k in [0.11, 0.31, 0.47, 0.7, 1.1, 1.7, 2.3, 3.1] {
        let x = k / RATE;
        // From 2^31 units to one, and a unit a step from 1/(2 x) on; the explicit one as long.
        let steps = (22.0 / x + 1.0 / x) as u32;
        let stuck = left::<S>(LinearDrag::new(ratio(k)).unwrap(), steps);
        let rest = left::<S>(ExactDrag::new(ratio(k)).unwrap(), steps);
        let zone = (0.5 / x).floor();
        off.extend(stuck.map(|v| (f64::from(v.abs()) - zone).abs()));
        assert_eq!(rest, [0; 16], "k {k}");
        println!("{} k {k}: explicit stops at {} units", S::name(), stuck[0]);
    }
    within(
        0.0,
        &format!("{} off the edge of the dead zone", S::name()),
        &off,
    );
}

#[test]
fn exact_drag_has_no_dead_zone_where_linear_drag_has_one() {
    check::<I16F16>();
    check::<I12F20>();
    check::<I8F24>();
}
