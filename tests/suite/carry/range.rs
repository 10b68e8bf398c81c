//! Bodies that carry at the ends of the range, and what their hash holds.

use fixstep::fixed::types::{I8F24, I12F20, I16F16, I20F12};
use fixstep::{Body, Carried, Factor, Gravity, Scalar, Step, Vec2, World};

use super::bits::{Fine, rests};
use crate::support::*;

/// Pulled towards a corner by a quarter of the range a second: position and velocity grow until they
/// stand at the end, keep their sign, and the body is reported from then on.
fn check_corner<S: Fine>(scheme: Scheme, signs: [f64; 2]) {
    let end = S::MAX.to_f64();
    let pull = vector::<S>(0.25 * end * signs[0], 0.25 * end * signs[1]);
    let start = point::<S>(signs.map(|s| 0.9 * end * s), [0.0; 2], 1.0);
    let mut world: World<Carried<S>, 1> = world([start.into()]);
    let (mut method, mut gravity) = (scheme.method(), Gravity::new(pull));
    let (step, mut reported) = (Step::hz(60).unwrap(), false);
    for tick in 0..360 {
        let before = world.bodies()[0];
        world.step(&mut method, &mut gravity, &step);
        let after = world.bodies()[0];
        for (axis, sign) in signs.into_iter().enumerate() {
            let parts = [before, after].map(|body| {
                [body.position(), body.velocity()].map(|v| sign * v.to_f64().array()[axis])
            });
            // At the lower end the last unit is seen or not: the upper word of a place saturates alone.
            let grows = (0..2).all(|k| parts[1][k] >= parts[0][k] - S::unit(0.0));
            assert!(grows, "{} {scheme:?} {signs:?} tick {tick}", S::name());
        }
        let out = world.out_of_range().count() == 1;
        assert!(out || !reported, "{} tick {tick}", S::name());
        reported = out;
    }
    let at_end = |v: Vec2<S>| {
        v.array()
            .map(|s| s.units().unsigned_abs() >= i32::MAX as u32)
    };
    let body = world.bodies()[0];
    assert!(reported);
    assert_eq!(
        [at_end(body.position()), at_end(body.velocity())],
        [[true; 2]; 2]
    );
}

fn check_corners<S: Fine>() {
    for scheme in SCHEMES {
        for signs in [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]] {
            check_corner::<S>(scheme, signs);
        }
    }
}

#[test]
fn it_saturates_keeps_its_sign_and_is_reported() {
    check_corners::<I16F16>();
    check_corners::<I12F20>();
    check_corners::<I8F24>();
    check_corners::<I20F12>();
}

/// Slow enough to pass every fraction of the last unit: 1/60 unit a step.
#[test]
fn the_last_unit_before_the_end_is_not_another_end() {
    let start = |sign: i32| {
        let x = I16F16::from_bits(sign * (i32::MAX - 1));
        let v = I16F16::from_bits(sign);
        Carried::new(Vec2::new(x, x), Vec2::new(v, v), 1).unwrap()
    };
    for sign in [1, -1] {
        let mut world: World<_, 1> = world([start(sign)]);
        for _ in 0..240 {
            let mut method = Scheme::Verlet.method();
            world.step(&mut method, &mut (), &Step::hz(60).unwrap());
            let x = world.bodies()[0].position().x.to_bits();
            assert!(
                x.unsigned_abs() >= i32::MAX as u32 - 1 && x.signum() == sign,
                "{x}"
            );
        }
        assert_eq!(world.out_of_range().count(), 1);
    }
}

/// Two bodies that look alike and differ in what is left over of one part of place or velocity.
fn check_hash<S: Fine>() {
    let still: Carried<S> = point([1.0, 2.0], [0.5, -0.25], 3.0).into();
    let small = S::Coef::new(ratio(0.25)).unwrap();
    let (x, y) = (
        Vec2::new(S::of_units(1), S::ZERO),
        Vec2::new(S::ZERO, S::of_units(1)),
    );
    let mut all = vec![still];
    for direction in [x, y] {
        for sign in [1, -1] {
            let part = direction.map(|s| S::of_units(s.units() * sign));
            let (mut moved, mut kicked) = (still, still);
            moved.move_by(part, small);
            kicked.kick_by(part, small);
            assert!(rests(&kicked) != [0; 2]);
            all.extend([moved, kicked]);
        }
    }
    let hash = |body: Carried<S>| world::<_, 1>([body]).state_hash();
    for (i, &one) in all.iter().enumerate() {
        assert!(one.position() == still.position() && one.velocity() == still.velocity());
        for &other in &all[..i] {
            assert!(
                one != other && hash(one) != hash(other),
                "{one:?} {other:?}"
            );
        }
        assert_eq!(hash(one), hash(one));
    }
}

#[test]
fn a_hash_holds_what_is_left_over() {
    check_hash::<I16F16>();
    check_hash::<I12F20>();
    check_hash::<I8F24>();
}

/// A float that has left its range: NaN has one hash, whatever its sign.
#[test]
fn a_float_beyond_the_range_is_reported() {
    let mut body: Carried<f32> = point([1.0, 2.0], [0.5, 0.0], 1.0).into();
    for _ in 0..3 {
        body.kick_by(Vec2::new(f32::MAX, f32::MAX), 4.0);
    }
    let world = world::<_, 1>([body]);
    assert_eq!(world.out_of_range().count(), 1);
    let (mut one, mut other) = (body, body);
    one.kick(Vec2::new(f32::NAN, 0.0));
    other.kick(Vec2::new(-f32::NAN, 0.0));
    let hash = |body| crate::support::world::<_, 1>([body]).state_hash();
    assert_eq!(hash(one), hash(other));
}

/// What a teleport or another velocity leaves over: nothing.
#[test]
fn a_body_that_is_put_elsewhere_has_nothing_left_over() {
    let mut body: Carried<I16F16> = point([1.0, 2.0], [0.5, 0.5], 3.0).into();
    let fresh = body;
    let (one, part) = (Vec2::new(I16F16::from_bits(1), I16F16::from_bits(-1)), 0.3);
    let part = <<I16F16 as Scalar>::Coef as Factor<I16F16>>::new(ratio(part)).unwrap();
    body.move_by(one, part);
    body.kick_by(one, part);
    assert!(body != fresh);
    body.teleport(fresh.position()).unwrap();
    body.set_velocity(fresh.velocity()).unwrap();
    assert!(body == fresh);
}
