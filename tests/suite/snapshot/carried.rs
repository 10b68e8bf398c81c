//! Bodies that carry in a snapshot: their layout, what tells them from points, and remainders that
//! no body has.

use fixstep::fixed::types::{I8F24, I12F20, I16F16, I20F12};
use fixstep::{Carried, Carry, Saved, SnapshotError, Step, Stored, Verlet, World, dec};

use super::bytes::{HEADER, ID, KIND, Kept, SIZE, get, with};
use super::samples::{self, ROOM};

type Few<S> = World<Carried<S>, ROOM>;

/// `count` bodies in free fall for seven ticks: places and velocities leave something over.
fn world<S: Kept + Carry>(count: usize) -> Few<S> {
    let mut world = Few::new();
    for &point in samples::world::<S>(count).bodies() {
        world.add(point.into()).unwrap();
    }
    let half = <S::Coef as OfRatio<S>>::of_ratio(dec!(0.3));
    for _ in 0..7 {
        for (_, body) in world.iter_mut() {
            fixstep::Body::kick_by(body, body.position(), half);
        }
        world.step(&mut Verlet, &mut (), &Step::hz(60).unwrap());
    }
    world
}

trait OfRatio<S> {
    fn of_ratio(ratio: fixstep::Ratio) -> Self;
}

impl<S, F: fixstep::Factor<S>> OfRatio<S> for F {
    fn of_ratio(ratio: fixstep::Ratio) -> Self {
        F::new(ratio).unwrap()
    }
}

fn saved<S: Kept + Carry>(world: &Few<S>) -> Vec<u8> {
    let mut bytes = vec![0; Few::<S>::SNAPSHOT];
    let length = world.save(&mut bytes).unwrap();
    bytes.truncate(length);
    bytes
}

/// Numbers of one size: two halves of two places, two velocities, the inverse mass; then the
/// remainders.
fn check_layout<S: Kept + Carry>(rest: usize) {
    let (size, three) = (size_of::<S>(), world::<S>(3));
    let (bytes, each) = (saved(&three), 7 * size + 2 * rest);
    assert_eq!(bytes.len(), HEADER + 3 * (ID + each), "{}", S::name());
    assert_eq!(<Carried<S> as Saved>::BYTES, each);
    assert_eq!((get(&bytes, KIND), get(&bytes, SIZE)), (2, each as u64));
    let mut left_over = 0;
    for (i, body) in three.bodies().iter().enumerate() {
        let start = HEADER + i * (ID + each) + ID;
        let number = |k: usize| get(&bytes, (start + k * size, size));
        let (v, mass) = (body.velocity(), fixstep::Body::inv_mass(body));
        assert_eq!([number(4), number(5)], v.array().map(S::store));
        assert_eq!(number(6), mass.store());
        // Rounded, the halves of a place are what is seen.
        let places = [[number(0), number(1)], [number(2), number(3)]];
        let seen = places.map(|halves| S::seen(S::from_halves(halves).unwrap()));
        assert!(seen == body.position().array());
        let rests = [0, 1].map(|k| get(&bytes, (start + 7 * size + k * rest, rest)));
        left_over += rests.iter().filter(|&&bits| bits != 0).count();
    }
    assert!(left_over >= 3, "{}: nothing left over", S::name());
    let again = Few::<S>::load(&bytes).unwrap();
    assert_eq!(again.bodies(), three.bodies());
    assert_eq!(saved(&again), bytes);
}

#[test]
fn a_body_that_carries_takes_32_bytes_in_32_bits() {
    check_layout::<f32>(2);
    check_layout::<I16F16>(2);
    check_layout::<I12F20>(2);
    check_layout::<I8F24>(2);
    check_layout::<I20F12>(2);
    check_layout::<f64>(4);
}

#[test]
fn points_are_not_mistaken_for_bodies_that_carry() {
    let (points, bodies) = (
        samples::saved(&samples::world::<I16F16>(3)),
        saved(&world::<I16F16>(3)),
    );
    let as_points = samples::Small::<I16F16>::load(&bodies).map(drop);
    assert_eq!(as_points, Err(SnapshotError::Kind(2)));
    let as_bodies = Few::<I16F16>::load(&points).map(drop);
    assert_eq!(as_bodies, Err(SnapshotError::Kind(1)));
    let other = Few::<I8F24>::load(&bodies).map(drop);
    assert_eq!(other, Err(SnapshotError::Scalar(0x0100_2010)));
}

/// Field of remainder `k` of the second body of an `I16F16`.
fn rest(k: usize) -> (usize, usize) {
    (HEADER + (ID + 32) + ID + 28 + 2 * k, 2)
}

// Half a unit is 2^14 of its parts; no remainder is larger.
#[test]
fn a_remainder_out_of_range_is_no_state() {
    let bytes = saved(&world::<I16F16>(3));
    for k in [0, 1] {
        for value in [0_i16, 1, -1, 1 << 14, -(1 << 14)] {
            let bytes = with(&bytes, rest(k), value as u16 as u64);
            assert_eq!(saved(&Few::<I16F16>::load(&bytes).unwrap()), bytes);
        }
        for value in [(1 << 14) + 1, -(1 << 14) - 1, i16::MAX, i16::MIN] {
            let bytes = with(&bytes, rest(k), value as u16 as u64);
            let found = Few::<I16F16>::load(&bytes).map(drop);
            assert_eq!(found, Err(SnapshotError::State), "{value}");
        }
    }
}

#[test]
fn a_mass_that_is_none_is_no_state() {
    let mass = (HEADER + ID + 24, 4);
    for bits in [0, 0x3FFF_FFFF, 0x8000_0000] {
        let bytes = with(&saved(&world::<I16F16>(3)), mass, bits);
        let found = Few::<I16F16>::load(&bytes).map(drop);
        assert_eq!(found, Err(SnapshotError::State));
    }
    let bytes = with(&saved(&world::<f32>(3)), mass, f32::NAN.to_bits().into());
    let found = Few::<f32>::load(&bytes).map(drop);
    assert_eq!(found, Err(SnapshotError::State));
}

#[test]
fn every_flipped_bit_is_refused() {
    let mut bytes = saved(&world::<I16F16>(3));
    for bit in 0..8 * bytes.len() {
        bytes[bit / 8] ^= 1 << (bit % 8);
        assert!(Few::<I16F16>::load(&bytes).is_err(), "bit {bit}");
        bytes[bit / 8] ^= 1 << (bit % 8);
    }
    for length in 0..bytes.len() {
        assert!(Few::<I16F16>::load(&bytes[..length]).is_err(), "{length}");
    }
}
