//! Forces and bodies without a dead zone. Gravity spreads its fraction over the ticks, `ExactDrag` takes
//! a unit at least, and a `Carried` keeps the product: to 15 bits for kicks, 32 for drifts.

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{
    Anchor, Body, BodyId, Carried, Carry, Decay, ExactDrag, Force, Gravity, LinearDrag, Point,
    Ratio, Vec2,
};

use crate::rounding::zones::*;
use crate::support::*;

fn exact<S: Grid + Decay>(case: &Case, _: BodyId) -> ExactDrag<S> {
    ExactDrag::new(case.k()).unwrap()
}

/// What is seen of it ends at zero.
fn check_stopped<B, F>(brake: impl Fn(&Case, BodyId) -> F)
where
    B: Body<S: Grid> + From<Point<B::S>> + std::fmt::Debug,
    F: Force<B>,
{
    for case in cases() {
        let (mut world, id) = scene::<B>(0, 3 * case.edge(), case.mass);
        run(&mut world, &mut brake(&case, id), case.rate, case.long());
        assert_eq!(velocity(&world), both(0), "{} {case:?}", B::S::name());
    }
}

#[test]
fn exact_drag_leaves_nothing() {
    check_stopped::<Point<I16F16>, _>(exact);
    check_stopped::<Point<I8F24>, _>(exact);
    check_stopped::<Carried<I16F16>, _>(exact);
    check_stopped::<Carried<I8F24>, _>(exact);
}

#[test]
fn a_carried_body_is_braked_to_rest() {
    check_stopped::<Carried<I16F16>, _>(drag);
    check_stopped::<Carried<I8F24>, _>(drag);
    check_stopped::<Carried<I16F16>, _>(damper);
    check_stopped::<Carried<I8F24>, _>(damper);
}

/// One unit away, each kick keeps `1 / (2 edges)` of a unit, which is half of one after as many steps
/// as the edge of a `Point` has units.
fn check_drawn<S: Grid + Carry>() {
    for case in cases() {
        let what = format!("{} {case:?}", S::name());
        let (mut world, id) = scene::<Carried<S>>(1, 0, case.mass);
        run(
            &mut world,
            &mut spring(&case, id),
            case.rate,
            case.edge() as u32,
        );
        assert_eq!(velocity(&world), both(0), "{what}");
        run(&mut world, &mut spring(&case, id), case.rate, 1);
        assert_eq!(velocity(&world), both(-1), "{what}");
    }
}

#[test]
fn a_spring_draws_a_carried_body_from_a_unit() {
    check_drawn::<I16F16>();
    check_drawn::<I8F24>();
}

/// A `Carried` rounds a kick to 2^-15 of a unit: a drag of p millionths at 60 Hz leaves velocities
/// below `60 · 10⁶ / (p 2^16) = 234375 / (256 p)` units.
fn check_fine<S: Grid + Carry>() {
    for p in 1..=16 {
        let edge = 234_375 / (256 * p);
        let mut drag = LinearDrag::<S>::new(Ratio::new(p.into(), 1_000_000).unwrap()).unwrap();
        let fine = |world: &Scene<Carried<S>>| {
            (world.bodies()[0].momentum().x / S::unit(0.0) * 32768.0) as i64
        };
        let (mut world, _) = scene::<Carried<S>>(0, edge, 1);
        run(&mut world, &mut drag, 60, 1000);
        assert_eq!(fine(&world), i64::from(edge) << 15, "{} {p}", S::name());
        let (mut world, _) = scene::<Carried<S>>(0, edge + 1, 1);
        run(&mut world, &mut drag, 60, 1000);
        let left = (i64::from(edge + 1) << 15) - 1000;
        assert_eq!(fine(&world), left, "{} {p}", S::name());
    }
}

#[test]
fn a_carried_bodys_own_zone_is_a_32768th() {
    check_fine::<I16F16>();
    check_fine::<I8F24>();
}

/// In ten seconds, ten units for each unit of velocity or of acceleration.
fn check_slow<S: Grid + Carry>() {
    for (i, rate) in rates().enumerate() {
        let (units, ticks) = (i as i32 + 1, 10 * rate as u32);
        let (mut world, _) = scene::<Carried<S>>(0, units, 1);
        run(&mut world, &mut (), rate, ticks);
        assert_eq!(
            position(&world),
            both(10 * units),
            "{} {rate} Hz",
            S::name()
        );
        let mut gravity = Gravity::new(both::<S>(units));
        let (mut world, _) = scene::<Point<S>>(0, 0, 1);
        run(&mut world, &mut gravity, rate, ticks);
        assert_eq!(
            velocity(&world),
            both(10 * units),
            "{} {rate} Hz",
            S::name()
        );
    }
}

#[test]
fn carried_drifts_and_gravity_have_no_dead_zone() {
    check_slow::<I16F16>();
    check_slow::<I8F24>();
}

/// A damped swing from three edges away, for 30 damping times: `2 m / c` is two seconds, and no case is
/// damped beyond its frequency. Where less than half a unit is left of place and velocity, nothing
/// acts any more.
fn check_settled<S: Grid + Carry>() {
    for case in cases() {
        let (mut world, id) = scene::<Carried<S>>(3 * case.edge(), 0, case.mass);
        let mut anchor = Anchor::new(id, Vec2::ZERO, case.k(), case.mass).unwrap();
        run(&mut world, &mut anchor, case.rate, 60 * case.rate as u32);
        let (x, v) = (position(&world), velocity(&world));
        let largest = [x.x, x.y, v.x, v.y]
            .map(|s| s.units().abs())
            .into_iter()
            .max();
        assert!(largest <= Some(1), "{} {case:?}: {x:?} {v:?}", S::name());
    }
}

#[test]
fn a_carried_swing_settles_within_a_unit() {
    check_settled::<I16F16>();
    check_settled::<I8F24>();
}
