//! What is logged with defmt: the values, in their order. The texts between them stay in the ELF file
//! and are not looked at; each stands in the log as two bytes.

use defmt::Format;
use defmt::export::fetch_bytes;
use fixstep::fixed::types::{I16F16, I32F32};
use fixstep::{
    Accumulator, Angle, Body, BodyId, Carried, Due, Error, Point, RangeChecked, Ratio, RewindError,
    Rigid, SnapshotError, Stale, Vec2, World, dec, vec2,
};

/// Asserts that `parts` stand in the log of `value`, one behind the other.
#[track_caller]
fn logs(value: &impl Format, parts: &[&[u8]]) {
    fetch_bytes();
    defmt::println!("{}", value);
    let log = fetch_bytes();
    let mut rest = log.as_slice();
    for part in parts {
        let place = rest.windows(part.len()).position(|window| window == *part);
        let Some(place) = place else {
            panic!("{part:x?} is not behind the others in {log:x?}");
        };
        rest = &rest[place + part.len()..];
    }
}

/// Bytes of the log of `value`.
fn length(value: &impl Format) -> usize {
    fetch_bytes();
    defmt::println!("{}", value);
    fetch_bytes().len()
}

fn point(x: i32) -> Point<f32> {
    Point::new(vec2(x, 7).unwrap(), vec2(dec!(-1.5), 9).unwrap(), 1).unwrap()
}

fn float(value: f32) -> [u8; 4] {
    value.to_le_bytes()
}

fn world() -> (World<Point<f32>, 2>, BodyId) {
    let mut world = World::new();
    world.add(point(3)).unwrap();
    let second = world.add(point(5)).unwrap();
    let step = fixstep::Step::hz(60).unwrap();
    for _ in 0..0x1234 {
        world.step(&mut fixstep::SemiImplicitEuler, &mut (), &step);
    }
    (world, second)
}

#[test]
fn vectors_show_both_components() {
    logs(&Vec2::new(1.5_f32, -2.25), &[&float(1.5), &float(-2.25)]);
    let fixed: Vec2<I16F16> = vec2(dec!(1.5), dec!(-2.25)).unwrap();
    logs(&fixed, &[b"1.5", b"-2.25"]);
}

#[test]
fn points_show_position_and_velocity() {
    let state = [3.0, 7.0, -1.5, 9.0].map(float);
    logs(&point(3), &[&state[0], &state[1], &state[2], &state[3]]);
}

#[test]
fn bodies_that_carry_show_the_same() {
    let state = [3.0, 7.0, -1.5, 9.0].map(float);
    let body = Carried::from(point(3));
    logs(&body, &[&state[0], &state[1], &state[2], &state[3]]);
}

// A negative angle, 3 / 8 of a turn back, which floats and fixed point hold; beside 64 bits too.
#[test]
fn angles_show_turns() {
    let back = dec!(-0.375);
    logs(&Angle::<f32>::turns(back), &[&float(-0.375)]);
    logs(&Angle::<f64>::turns(back), &[&(-0.375_f64).to_le_bytes()]);
    logs(&Angle::<I16F16>::turns(back), &[b"-0.375"]);
    logs(&Angle::<I32F32>::turns(back), &[b"-0.375"]);
}

#[test]
fn bodies_that_turn_show_angle_spin_and_whether_they_are_driven() {
    let state = [3.0, 7.0, -1.5, 9.0, -0.375, 0.625]
        .map(float)
        .map(Vec::from);
    let parts: Vec<&[u8]> = state.iter().map(Vec::as_slice).collect();
    let angle = Angle::turns(dec!(-0.375));
    let turning = |body: Rigid<Point<f32>>| body.with_angle(angle).with_spin(dec!(0.625)).unwrap();
    let body = turning(Rigid::new(point(3), 1).unwrap());
    let driven = turning(Rigid::kinematic(body.position(), body.velocity()).unwrap());
    logs(&body, &parts);
    logs(&driven, &parts);
    assert!(length(&driven) > length(&body));
    let carried = Rigid::new(Carried::from(point(3)), 1).unwrap();
    logs(
        &carried.with_angle(angle).with_spin(dec!(0.625)).unwrap(),
        &parts,
    );
}

#[test]
fn worlds_show_tick_and_bodies() {
    let (world, second) = world();
    let at = |i: usize| float(fixstep::Body::position(&world.bodies()[i]).x);
    let tick = 0x1234_u64.to_le_bytes();
    logs(
        &world,
        &[&tick, &2_u32.to_le_bytes(), &at(0), &at(1), &float(9.0)],
    );
    logs(&second, &[&1_u32.to_le_bytes()]);
    logs(&Stale(second), &[&1_u32.to_le_bytes()]);
}

#[test]
fn ratios_show_numerator_and_denominator() {
    let (num, den) = ((-981_i64).to_le_bytes(), 100_u64.to_le_bytes());
    logs(&dec!(-9.81), &[&num, &den]);
    logs(&Ratio::from(-981), &[&num]);
}

#[test]
fn a_frame_shows_what_is_due_and_what_is_dropped() {
    let mut clock = Accumulator::new(1000, Ratio::new(1, 100).unwrap(), 4).unwrap();
    let due: Due = clock.advance(770);
    logs(&due, &[&4_u32.to_le_bytes(), &73_u64.to_le_bytes()]);
}

#[test]
fn errors_show_the_value_they_refuse() {
    let (field, value) = ("mass", dec!(-9.81));
    let num = (-981_i64).to_le_bytes();
    logs(&Error::NotPositive { field, value }, &[b"mass", &num]);
    logs(&Error::Negative { field, value }, &[b"mass", &num]);
    logs(&Error::OutOfRange { field, value }, &[b"mass", &num]);
    logs(&Error::RoundsToZero { field, value }, &[b"mass", &num]);
    logs(&Error::NotFinite { field }, &[b"mass"]);
    logs(&Error::NotANumber { field }, &[b"mass"]);
    logs(&Error::Empty { field }, &[b"mass"]);
    logs(&Error::Degenerate { shape: "polygon" }, &[b"polygon"]);
    logs(&Error::NotConvex { vertex: 7 }, &[&7_u32.to_le_bytes()]);
    let (mut world, _) = world();
    let full = world.add(point(1)).unwrap_err();
    logs(&full, &[&2_u32.to_le_bytes()]);
}

#[test]
fn snapshot_errors_show_what_was_found() {
    use SnapshotError::*;
    let word = u32::to_le_bytes;
    logs(
        &Length {
            needed: 112,
            given: 64,
        },
        &[&word(112), &word(64)],
    );
    logs(&Version(0x5A7E), &[&0x5A7E_u16.to_le_bytes()]);
    logs(&Kind(0x8001), &[&0x8001_u16.to_le_bytes()]);
    logs(&Scalar(0x0200_0020), &[&word(0x0200_0020)]);
    logs(
        &Full {
            bodies: 77,
            capacity: 8,
        },
        &[&word(77), &word(8)],
    );
    for error in [NotASnapshot, Checksum, State] {
        logs(&error, &[]);
    }
}

#[test]
fn watched_bodies_show_body_and_mark() {
    let mut ball = RangeChecked::new(point(3));
    let state = [3.0, 7.0, -1.5, 9.0].map(float).concat();
    logs(&ball, &[&state[..4], &state[12..]]);
    let unmarked = length(&ball);
    ball.kick(vec2(dec!(0), 0).unwrap());
    assert_eq!(length(&ball), unmarked);
    (0..2).for_each(|_| ball.kick(Vec2::new(f32::MAX, f32::MAX))); // infinite
    assert!(length(&ball) > unmarked);
}

#[test]
fn refusals_to_go_back_show_body_and_force() {
    let (_, body) = world();
    logs(
        &RewindError::Saturated { body },
        &[&body.serial().to_le_bytes()],
    );
    logs(&RewindError::Damped { force: "Spring" }, &[b"Spring"]);
}
