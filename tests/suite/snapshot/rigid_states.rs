//! States that no body that turns has are refused; every other comes back bit for bit.

use fixstep::fixed::types::I16F16;
use fixstep::{Carried, Point, Rigid, Saved, SnapshotError, World};

use super::bytes::with;
use super::rigid::{INVERSE_F32, bytes, driven, field, one};
use super::samples::saved;

type Fixed = Rigid<Point<I16F16>>;
type Float = Rigid<Point<f32>>;
type Carrying = Rigid<Carried<I16F16>>;

/// Two points: one that is moved by forces and one that is driven.
fn two<S>() -> Vec<u8>
where
    Rigid<Point<S>>: Saved<S = S>,
    S: fixstep::Angular,
{
    bytes([one::<Point<S>>(), driven()])
}

#[track_caller]
fn check<B: Saved>(bytes: &[u8], field: (usize, usize), values: &[u64], taken: bool) {
    for &value in values {
        let bytes = with(bytes, field, value);
        match World::<B, 5>::load(&bytes) {
            Ok(world) => assert!(taken && saved(&world) == bytes, "{value:#x}"),
            Err(error) => assert!(!taken && error == SnapshotError::State, "{value:#x}"),
        }
    }
}

// A driven body without its mark is one of 1 kg that is locked. One of inertia is not driven.
#[test]
fn a_mark_is_one_of_a_driven_body() {
    let (fixed, float) = (two::<I16F16>(), two::<f32>());
    let mark = |size, i| field(size, i, 0, 1);
    check::<Fixed>(&fixed, mark(34, 1), &[0, 1], true);
    check::<Fixed>(&fixed, mark(34, 0), &[1, 2, 3, 0x80, 255], false);
    check::<Fixed>(&fixed, mark(34, 1), &[2, 3, 0x81, 255], false);
    check::<Float>(&float, mark(33, 1), &[0, 1], true);
    check::<Float>(&float, mark(33, 0), &[1, 2, 255], false);
}

#[test]
fn a_driven_body_weighs_its_kilogram_and_is_not_turned() {
    let (fixed, float) = (two::<I16F16>(), two::<f32>());
    let half = 0x4000_000B;
    let (mass, two) = (field(34, 1, 17, 4), 2.0_f32.to_bits().into());
    check::<Fixed>(&fixed, mass, &[half, 0], false);
    check::<Float>(&float, field(33, 1, 17, 4), &[two, 0], false);
    let inverse = 33 << 32 | 0x517C_C1B7;
    check::<Fixed>(&fixed, field(34, 1, 29, 5), &[inverse], false);
    let inverse = u64::from(INVERSE_F32);
    check::<Float>(&float, field(33, 1, 29, 4), &[inverse], false);
    // The other body may.
    check::<Fixed>(&fixed, field(34, 0, 17, 4), &[half], true);
}

// A mantissa without its highest bit has lost precision, one below zero would spin against every push.
// There is one zero.
#[test]
fn an_inverse_inertia_of_fixed_point_is_normalised_and_not_negative() {
    let bytes = two::<I16F16>();
    let inverse = field(34, 0, 29, 5);
    let of = |mantissa: u32, shift: u64| shift << 32 | u64::from(mantissa);
    let taken = [0x4000_0000, 0x517C_C1B7, 0x7FFF_FFFF];
    let wrong = [
        1,
        0x3FFF_FFFF,
        0x8000_0000,
        0x8000_0001,
        0xC000_0000,
        u32::MAX,
    ];
    for shift in [1, 2, 31, 33, 61, 62] {
        let of = |mantissas: &[u32]| mantissas.iter().map(|&m| of(m, shift)).collect::<Vec<_>>();
        check::<Fixed>(&bytes, inverse, &of(&taken), true);
        check::<Fixed>(&bytes, inverse, &of(&wrong), false);
    }
    for shift in [0, 63, 64, 255] {
        check::<Fixed>(&bytes, inverse, &[of(0x4000_0000, shift)], false);
    }
    let zeros = [0, 1, 15, 17, 62, 63].map(|shift| of(0, shift));
    check::<Fixed>(&bytes, inverse, &zeros, false);
    check::<Fixed>(&bytes, inverse, &[of(0, 16)], true);
}

#[test]
fn an_inverse_inertia_of_a_float_is_finite_and_not_negative() {
    let inverse = field(33, 0, 29, 4);
    let of = |values: &[f32]| {
        values
            .iter()
            .map(|v| v.to_bits().into())
            .collect::<Vec<_>>()
    };
    let least = f32::from_bits(1);
    let taken = of(&[0.0, -0.0, least, f32::MIN_POSITIVE, 1.0, f32::MAX]);
    check::<Float>(&two::<f32>(), inverse, &taken, true);
    let (nan, infinite) = (f32::NAN, f32::INFINITY);
    let wrong = of(&[-least, -1.0, -f32::MAX, nan, -nan, infinite, -infinite]);
    check::<Float>(&two::<f32>(), inverse, &wrong, false);
}

// All bits of an angle are a fraction of a turn, and a spin may be what a velocity may.
#[test]
fn any_angle_and_any_spin_come_back() {
    let any = [
        0,
        1,
        0x7FFF_FFFF,
        0x8000_0000,
        0x7FC1_2345,
        0xFF80_0001,
        u64::from(u32::MAX),
    ];
    for at in [21, 25] {
        check::<Fixed>(&two::<I16F16>(), field(34, 0, at, 4), &any, true);
        check::<Float>(&two::<f32>(), field(33, 1, at, 4), &any, true);
    }
    let carried = bytes([one::<Carried<I16F16>>(), driven()]);
    for at in [33, 37, 41] {
        check::<Carrying>(&carried, field(52, 1, at, 4), &any, true);
    }
}

// Half a unit is 2^14 of its parts.
#[test]
fn a_remainder_of_a_spin_is_at_most_half_a_unit() {
    let carried = bytes([one::<Carried<I16F16>>(), driven()]);
    let rest = field(52, 0, 50, 2);
    let bits = |values: &[i16]| {
        values
            .iter()
            .map(|&v| u64::from(v as u16))
            .collect::<Vec<_>>()
    };
    check::<Carrying>(
        &carried,
        rest,
        &bits(&[0, 1, -1, 1 << 14, -(1 << 14)]),
        true,
    );
    let wrong = bits(&[(1 << 14) + 1, -(1 << 14) - 1, i16::MAX, i16::MIN]);
    check::<Carrying>(&carried, rest, &wrong, false);
    // Nor does the check of the inverse inertia look away from bodies that carry.
    let inverse = field(52, 0, 45, 5);
    check::<Carrying>(&carried, inverse, &[62 << 32 | 0xC000_0000], false);
}
