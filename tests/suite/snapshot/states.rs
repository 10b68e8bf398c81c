//! States that no world has are refused, and every state that one can have comes back bit for bit.

use fixstep::fixed::types::{I8F24, I16F16, I32F32};
use fixstep::{Body, Point, SnapshotError, Vec2, World};

use super::bytes::{self, ID, Kept, body, with};
use super::samples::{Small, saved, world};

/// Field of the id of body `i`.
fn id<S>(i: usize) -> (usize, usize) {
    (body::<S>(i) - ID, ID)
}

/// Field of number `k` of body `i`: x, y, u, v, inverse mass.
fn number<S>(i: usize, k: usize) -> (usize, usize) {
    (body::<S>(i) + k * size_of::<S>(), size_of::<S>())
}

#[track_caller]
fn refused<S: Kept>(bytes: &[u8]) {
    let found = Small::<S>::load(bytes).map(drop);
    assert_eq!(found, Err(SnapshotError::State), "{}", S::name());
}

/// Reads, and writes the same bytes again.
#[track_caller]
fn kept<S: Kept>(bytes: &[u8]) -> Small<S> {
    let world = Small::<S>::load(bytes).unwrap();
    assert_eq!(saved(&world), bytes);
    world
}

// Three bodies have the ids 0, 2 and 3, and the next is 4.
#[test]
fn ids_rise() {
    let three = saved(&world::<I16F16>(3));
    for serial in [0, 3, 4, u32::MAX.into()] {
        refused::<I16F16>(&with(&three, id::<I16F16>(1), serial));
    }
    let serials = kept::<I16F16>(&with(&three, id::<I16F16>(1), 1))
        .ids()
        .to_vec();
    assert_eq!(
        serials.iter().map(|id| id.serial()).collect::<Vec<_>>(),
        [0, 1, 3]
    );
}

#[test]
fn the_next_id_is_one_that_none_has() {
    let three = saved(&world::<I16F16>(3));
    for next in [0, 1, 3, (1 << 32) + 1, 1 << 33, 1 << 63, u64::MAX] {
        refused::<I16F16>(&with(&three, bytes::NEXT, next));
    }
    let extra = world::<I16F16>(1).bodies()[0];
    for next in [4, 5, u32::MAX] {
        let mut world = kept::<I16F16>(&with(&three, bytes::NEXT, next.into()));
        assert_eq!(world.add(extra).unwrap().serial(), next);
    }
}

#[test]
fn a_world_that_gave_its_last_id_stays_so() {
    let three = saved(&world::<I16F16>(3));
    let mut last = kept::<I16F16>(&with(&three, bytes::NEXT, u32::MAX.into()));
    let extra = last.bodies()[0];
    last.add(extra).unwrap();
    let bytes = saved(&last);
    assert_eq!(bytes::get(&bytes, bytes::NEXT), 1 << 32);
    let mut world = kept::<I16F16>(&bytes);
    assert!(world.len() < 8 && world.add(extra).is_err());
}

#[test]
fn any_tick_goes_on() {
    let three = saved(&world::<I8F24>(3));
    for tick in [0, 1, u32::MAX.into(), 1 << 32, 1 << 63, u64::MAX] {
        assert_eq!(kept::<I8F24>(&with(&three, bytes::TICK, tick)).tick(), tick);
    }
}

// A mantissa without its highest bit has lost precision; zero and less are no mass.
#[test]
fn an_inverse_mass_of_fixed_point_is_normalised_and_positive() {
    let (small, wide) = (saved(&world::<I16F16>(3)), saved(&world::<I32F32>(3)));
    for bits in [
        0,
        1,
        31,
        0x2000_000A,
        0x3FFF_FFFF,
        0x8000_0000,
        0xC000_000A,
        u32::MAX,
    ] {
        refused::<I16F16>(&with(&small, number::<I16F16>(1, 4), bits.into()));
        refused::<I32F32>(&with(&wide, number::<I32F32>(1, 4), u64::from(bits) << 32));
    }
    for bits in [0x4000_0000, 0x4000_001F, 0x7FFF_FFFF] {
        kept::<I16F16>(&with(&small, number::<I16F16>(1, 4), bits));
        kept::<I32F32>(&with(&wide, number::<I32F32>(1, 4), bits << 32));
    }
}

#[test]
fn an_inverse_mass_of_a_float_is_finite_and_positive() {
    let (small, wide) = (saved(&world::<f32>(3)), saved(&world::<f64>(3)));
    let payload = f64::from_bits(f64::NAN.to_bits() | 1 << 40);
    for value in [
        0.0,
        -0.0,
        -1.0,
        f64::NAN,
        -f64::NAN,
        payload,
        f64::INFINITY,
        f64::NEG_INFINITY,
    ] {
        refused::<f64>(&with(&wide, number::<f64>(2, 4), value.to_bits()));
        refused::<f32>(&with(
            &small,
            number::<f32>(2, 4),
            (value as f32).to_bits().into(),
        ));
    }
    for value in [1.0_f32, 1e-30, 1e30] {
        kept::<f32>(&with(&small, number::<f32>(2, 4), value.to_bits().into()));
    }
}

// NaN quiet, signalling, negative and with a payload; zeros, infinities, subnormals.
const ODD: [u32; 10] = [
    0x7FC0_0000,
    0x7F80_0001,
    0xFFC1_2345,
    0x7FFF_FFFF,
    0,
    0x8000_0000,
    0x7F80_0000,
    0xFF80_0000,
    1,
    0x807F_FFFF,
];

#[test]
fn odd_floats_come_back_as_they_were() {
    let bytes = saved(&world::<f32>(3));
    for (bits, k) in ODD
        .into_iter()
        .flat_map(|bits| (0..4).map(move |k| (bits, k)))
    {
        let world = kept::<f32>(&with(&bytes, number::<f32>(1, k), bits.into()));
        let body = world.bodies()[1];
        let numbers = [body.position().array(), body.velocity().array()].concat();
        assert_eq!(numbers[k].to_bits(), bits);
    }
}

#[test]
fn fixed_point_comes_back_from_the_ends_of_its_range() {
    let bytes = saved(&world::<I8F24>(3));
    for (bits, k) in [i32::MIN, i32::MAX, -1, 0].into_iter().zip(0..4) {
        kept::<I8F24>(&with(&bytes, number::<I8F24>(0, k), bits as u32 as u64));
    }
}

// Not written by hand: velocities that became infinite, and then no number.
#[test]
fn a_world_that_went_to_nan_is_kept() {
    let mut world = World::<Point<f32>, 8>::new();
    let id = world
        .add(Point::new(Vec2::ZERO, Vec2::ZERO, 1).unwrap())
        .unwrap();
    let body = world.get_mut(id).unwrap();
    body.kick(Vec2::new(f32::INFINITY, -0.0));
    body.kick(Vec2::new(f32::NEG_INFINITY, -0.0));
    assert!(body.velocity().x.is_nan() && world.out_of_range().count() == 1);
    let again = kept::<f32>(&saved(&world));
    assert_eq!(again.state_hash(), world.state_hash());
}
