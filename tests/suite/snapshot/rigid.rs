//! Bodies that turn in a snapshot: every byte, what tells them from others, and that they come back.

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{
    Angle, Body, Carried, Kind, Point, RangeChecked, Rigid, Saved, SnapshotError, Vec2, World, dec,
    vec2,
};

use super::bytes::{HEADER, ID, KIND, SIZE, get, with};
use super::cast::Cast;
use super::samples::saved;
use super::scenes::{Scene, start};

/// `1 / 2π` is `0.28BE 60DB 93`... of hexadecimal digits: with 31 bits `517C C1B7` over `2^33`, as a float
/// of 24 bits `A2F983` over `2^26`.
pub const INVERSE: [u8; 5] = [0xB7, 0xC1, 0x7C, 0x51, 33];
pub const INVERSE_F32: u32 = 0x3E22_F983;

/// A kilogram of 1 kg m² at (0, 2) with (3, -1), a quarter turn on, with half a turn a second.
pub fn one<C: fixstep::rigid::Centre + From<Point<C::S>>>() -> Rigid<C> {
    let point = Point::new(vec2(0, 2).unwrap(), vec2(3, -1).unwrap(), 1).unwrap();
    let body = Rigid::new(C::from(point), 1).unwrap();
    let body = body.with_angle(Angle::turns(dec!(0.25)));
    body.with_spin(dec!(0.5)).unwrap()
}

/// The same, moved by nothing but its velocity and spin.
pub fn driven<C: fixstep::rigid::Centre + From<Point<C::S>>>() -> Rigid<C> {
    let body = one::<C>();
    let driven = Rigid::kinematic(body.position(), body.velocity()).unwrap();
    let driven = driven.with_angle(body.angle());
    driven.with_spin(dec!(0.5)).unwrap()
}

/// A field of body `i`, where each has `size` bytes.
pub fn field(size: usize, i: usize, at: usize, count: usize) -> (usize, usize) {
    (HEADER + i * (ID + size) + ID + at, count)
}

pub fn bytes<B: Saved + std::fmt::Debug>(bodies: [B; 2]) -> Vec<u8> {
    saved(&crate::support::world(bodies))
}

/// Fails where version 1 becomes another format.
fn golden<B: Saved + std::fmt::Debug + PartialEq>(
    bodies: [B; 2],
    kind: u64,
    expected: [&[&[u8]]; 2],
) {
    let bytes = bytes(bodies);
    let [first, second] = expected.map(<[_]>::concat);
    assert_eq!(
        (get(&bytes, KIND), get(&bytes, SIZE)),
        (kind, first.len() as u64)
    );
    assert_eq!(B::BYTES, first.len());
    let expected = [&[0; ID][..], &first, &[1, 0, 0, 0], &second].concat();
    assert_eq!(bytes[HEADER..], expected);
    assert_eq!(World::<B, 2>::load(&bytes).unwrap().bodies(), bodies);
}

fn words<const N: usize>(words: [u32; N]) -> Vec<u8> {
    words.into_iter().flat_map(u32::to_le_bytes).collect()
}

const KILOGRAM: u32 = 1 << 30 | 10;
const QUARTER: u32 = 1 << 30;

// Nothing turns a driven body: a mantissa of zero, over 2^16 as the scalar has it.
const NONE: [u8; 5] = [0, 0, 0, 0, 16];

#[test]
fn every_byte_of_a_point_that_turns() {
    let centre = words([0, 2 << 16, 3 << 16, -(1_i32 << 16) as u32, KILOGRAM]);
    let turning = words([QUARTER, 1 << 15]);
    golden(
        [one::<Point<I16F16>>(), driven()],
        3,
        [
            &[&[0], &centre, &turning, &INVERSE],
            &[&[1], &centre, &turning, &NONE],
        ],
    );
    let centre = words([0, 0x4000_0000, 0x4040_0000, 0xBF80_0000, 0x3F80_0000]);
    let turning = words([QUARTER, 0x3F00_0000]);
    golden(
        [one::<Point<f32>>(), driven()],
        3,
        [
            &[&[0], &centre, &turning, &INVERSE_F32.to_le_bytes()],
            &[&[1], &centre, &turning, &[0; 4]],
        ],
    );
}

#[test]
fn every_byte_of_a_body_that_turns_and_carries() {
    let place = [0, 0, 2 << 16, 0];
    let velocity = [3 << 16, -(1_i32 << 16) as u32, KILOGRAM];
    // Two remainders of 2 bytes are one word of zero.
    let centre = [words(place), words(velocity), words([0])].concat();
    let turning = words([QUARTER, 0, 1 << 15]);
    golden(
        [one::<Carried<I16F16>>(), driven()],
        4,
        [
            &[&[0], &centre, &turning, &INVERSE, &[0; 2]],
            &[&[1], &centre, &turning, &NONE, &[0; 2]],
        ],
    );
    // A mark behind: whether it was outside.
    let watched = [
        RangeChecked::new(one::<Point<I16F16>>()),
        RangeChecked::new(driven()),
    ];
    let plain = bytes(watched.map(|body| *body.body()));
    let [first, second] = [0, 1].map(|i| &plain[HEADER + i * 38 + ID..][..34]);
    golden(watched, 3 | 0x4000, [&[first, &[0]], &[second, &[0]]]);
}

/// Centre, a byte, an angle or two halves of one, a spin, an inverse inertia, a remainder.
#[test]
fn sizes_are_those_of_the_documentation() {
    assert_eq!(Rigid::<Point<I16F16>>::BYTES, 20 + 1 + 4 + 4 + 5);
    assert_eq!(Rigid::<Point<I8F24>>::BYTES, 34);
    assert_eq!(Rigid::<Point<f32>>::BYTES, 20 + 1 + 4 + 4 + 4);
    assert_eq!(Rigid::<Carried<I16F16>>::BYTES, 32 + 1 + 8 + 4 + 5 + 2);
    assert_eq!(Rigid::<Carried<f32>>::BYTES, 32 + 1 + 8 + 4 + 4 + 2);
    assert_eq!(Rigid::<Point<f64>>::BYTES, 40 + 1 + 8 + 8 + 8);
    assert_eq!(Rigid::<Carried<f64>>::BYTES, 64 + 1 + 16 + 8 + 8 + 4);
    assert_eq!(RangeChecked::<Rigid<Point<f32>>>::BYTES, 34);
}

fn kinds_of<B: Cast>() -> [usize; 3] {
    let (world, bytes) = (start::<B>(1), saved(&start::<B>(1)));
    let again = Scene::<B>::load(&bytes).unwrap();
    let (mut driven, mut locked) = (0, 0);
    for (body, again) in world.bodies().iter().zip(again.bodies()) {
        assert_eq!(format!("{body:?}"), format!("{again:?}"));
        driven += usize::from(again.has_infinite_mass());
        locked += usize::from(!again.has_infinite_mass() && again.spin_momentum() == 0.0);
    }
    [world.len(), driven, locked]
}

#[test]
fn driven_and_locked_bodies_come_back() {
    let expected = [5, 1, 1];
    assert_eq!(kinds_of::<Rigid<Point<f32>>>(), expected);
    assert_eq!(kinds_of::<Rigid<Point<I16F16>>>(), expected);
    assert_eq!(kinds_of::<Rigid<Carried<I8F24>>>(), expected);
    assert_eq!(kinds_of::<RangeChecked<Rigid<Point<I8F24>>>>(), expected);
    let wall = Rigid::<Point<I16F16>>::static_at(vec2(5, 5).unwrap()).unwrap();
    let bytes = bytes([wall, driven()]);
    let mut again = World::<Rigid<Point<I16F16>>, 2>::load(&bytes).unwrap();
    assert_eq!(again.bodies()[0].kind(), Kind::Static);
    assert_eq!(again.bodies()[1].kind(), Kind::Kinematic);
    for (_, body) in again.iter_mut() {
        body.push(vec2(100, 100).unwrap());
        body.kick(vec2(100, 100).unwrap());
    }
    assert_eq!(saved(&again), bytes);
}

fn refused<B: Saved>(bytes: &[u8]) -> SnapshotError {
    World::<B, 5>::load(bytes).map(drop).unwrap_err()
}

#[test]
fn kinds_are_not_mistaken_for_one_another() {
    let plain = bytes([one::<Point<I16F16>>(), driven()]);
    let carried = bytes([one::<Carried<I16F16>>(), driven()]);
    let watched = bytes([
        RangeChecked::new(one::<Point<I16F16>>()),
        RangeChecked::new(driven()),
    ]);
    let kind = SnapshotError::Kind;
    assert_eq!(refused::<Point<I16F16>>(&plain), kind(3));
    assert_eq!(refused::<Rigid<Carried<I16F16>>>(&plain), kind(3));
    assert_eq!(refused::<Rigid<Point<I16F16>>>(&carried), kind(4));
    assert_eq!(refused::<Rigid<Point<I16F16>>>(&watched), kind(0x4003));
    let format = SnapshotError::Scalar(0x0100_2010);
    assert_eq!(refused::<Rigid<Point<I8F24>>>(&plain), format);
    let points = saved(&start::<Point<I16F16>>(0));
    assert_eq!(refused::<Rigid<Point<I16F16>>>(&points), kind(1));
    let grown = with(&plain, SIZE, 33);
    assert_eq!(refused::<Rigid<Point<I16F16>>>(&grown), kind(3));
}

// What turned once has something left over, and takes it along.
#[test]
fn what_is_left_over_comes_along() {
    let mut world = crate::support::world([one::<Carried<I16F16>>(), driven()]);
    let step = fixstep::Step::hz(60).unwrap();
    for _ in 0..7 {
        let (_, body) = world.iter_mut().next().unwrap();
        let third = I16F16::from_bits(0x5555);
        fixstep::Rotating::push_off(body, Vec2::new(third, third), vec2(0, dec!(0.1)).unwrap());
        world.step(&mut fixstep::SemiImplicitEuler, &mut (), &step);
    }
    let bytes = saved(&world);
    for (at, count) in [(37, 4), (50, 2)] {
        assert_ne!(get(&bytes, field(52, 0, at, count)), 0);
    }
    let again = World::<Rigid<Carried<I16F16>>, 2>::load(&bytes).unwrap();
    assert_eq!(again.bodies(), world.bodies());
}
