//! Where a force or a velocity rounds to nothing for a `Point`: below half a unit of a product.
//!
//! ```text
//! LinearDrag, damping of an Anchor    |v| < m / (2 k h) units keeps its velocity
//! stiffness of an Anchor              |x - a| < m / (2 k h) units is not drawn back
//! drift                               |v| < 1 / (2 h) units does not move; under Verlet, 1 / h
//! ```
//!
//! All numbers are whole units or fractions, so that the zones are met exactly.

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{BodyId, Force, Point, Step};

use crate::rounding::zones::*;
use crate::support::*;

/// Up to three edges a kick is one unit, so that a velocity of three falls to the edge in as many steps
/// as there are units between; there it stays.
fn check_braked<S: Grid, F: Force<Point<S>>>(brake: impl Fn(&Case, BodyId) -> F) {
    for case in cases() {
        let (edge, three) = (case.edge(), 3 * case.edge());
        let (mut world, id) = scene::<Point<S>>(0, three, case.mass);
        let mut force = brake(&case, id);
        run(&mut world, &mut force, case.rate, (three - edge) as u32 - 1);
        assert_eq!(velocity(&world), both(edge + 1), "{} {case:?}", S::name());
        run(&mut world, &mut force, case.rate, 1001);
        assert_eq!(velocity(&world), both(edge), "{} {case:?}", S::name());
    }
}

#[test]
fn linear_drag_leaves_what_rounds_to_nothing() {
    check_braked::<I16F16, _>(drag);
    check_braked::<I8F24, _>(drag);
}

#[test]
fn the_damper_of_an_anchor_leaves_the_same() {
    check_braked::<I16F16, _>(damper);
    check_braked::<I8F24, _>(damper);
}

fn check_drawn<S: Grid>() {
    for case in cases() {
        let (edge, what) = (case.edge(), format!("{} {case:?}", S::name()));
        let (mut world, id) = scene::<Point<S>>(edge, 0, case.mass);
        let before = world.bodies()[0];
        run(&mut world, &mut spring(&case, id), case.rate, 1000);
        assert_eq!(world.bodies()[0], before, "{what}");
        let (mut world, id) = scene::<Point<S>>(edge + 1, 0, case.mass);
        run(&mut world, &mut spring(&case, id), case.rate, 1);
        assert_eq!(velocity(&world), both(-1), "{what}");
    }
}

#[test]
fn a_spring_does_not_draw_from_within_its_edge() {
    check_drawn::<I16F16>();
    check_drawn::<I8F24>();
}

/// Of 1000 steps at a rate r: none of `v < r/2` moves a point, each of `v = r/2 + 1` or a half less
/// moves it by a unit. Half drifts, two a step, do so at r and r + 1.
fn check_drift<S: Grid>() {
    for rate in rates() {
        let zones = [
            (Scheme::SemiImplicitEuler, (rate - 1) / 2, rate / 2 + 1),
            (Scheme::Verlet, rate - 1, rate + 1),
        ];
        for (scheme, stays, moves) in zones {
            for (v, units) in [(stays, 0.0), (moves, 1000.0 * scheme.drifts())] {
                let (mut world, _) = scene::<Point<S>>(0, v, 1);
                let (mut method, step) = (scheme.method(), Step::hz(rate).unwrap());
                (0..1000).for_each(|_| world.step(&mut method, &mut (), &step));
                let what = format!("{} {scheme:?} {rate} Hz, {v} units", S::name());
                assert_eq!(position(&world), both(units as i32), "{what}");
            }
        }
    }
}

#[test]
fn a_slow_point_does_not_drift() {
    check_drift::<I16F16>();
    check_drift::<I8F24>();
}
