//! What an exact spring asks of a carried body, beside 128-bit integers: its distance from a point,
//! half a turn, and a kick by a number with a remainder. Each is odd, and loses nothing it need not.

use fixstep::fixed::types::{I8F24, I16F16};

use super::bits::{FINE, Fine, LIMIT, coef, fine_of, rounded};
use super::verbs::{factor, number, rest};
use crate::support::*;

/// Any place but the two that no negation has.
fn place(random: &mut Random) -> i64 {
    let low = if random.next().is_multiple_of(2) {
        0
    } else {
        random.next() as u32
    };
    (number(random).max(-i32::MAX) as i64) << 32 | low as i64
}

fn check_beyond<S: Fine>() {
    let mut random = Random(17);
    for _ in 0..long(60_000) {
        let (at, from) = (
            place(&mut random),
            S::of_units(number(&mut random).max(-i32::MAX)),
        );
        let (z, left) = S::beyond(at, from);
        let exact = at as i128 - ((from.units() as i128) << 32);
        let what = format!("{at:#x} {from:?}");
        assert!(left.unsigned_abs() <= 1 << (FINE - 1), "{what}");
        // At the end of the range a place shows the end, whatever it holds beyond.
        let inside = (at >> 32).abs() < i32::MAX as i64;
        if inside && exact.abs() < (i32::MAX as i128 - 1) << 32 {
            assert_eq!(fine_of(z, left), rounded(exact, 32 - FINE), "{what}");
            assert_eq!(
                S::beyond(-at, from.negated()),
                (z.negated(), -left),
                "{what}"
            );
        } else if inside {
            assert!(z.units().unsigned_abs() >= i32::MAX as u32 - 1, "{what}");
            assert_eq!(z.units() > 0, exact > 0, "{what}");
        }
    }
}

fn check_mirrored<S: Fine>() {
    let mut random = Random(19);
    for _ in 0..long(60_000) {
        let (at, about) = (place(&mut random), S::of_units(number(&mut random)));
        let exact = ((about.units() as i128) << 33) - at as i128;
        let found = S::mirrored(at, about) as i128;
        let what = format!("{at:#x} {about:?}");
        if (i64::MIN as i128..=i64::MAX as i128).contains(&exact) {
            assert_eq!(found, exact, "{what}");
        } else {
            // The upper half saturates alone.
            let end = if exact > 0 { i32::MAX } else { i32::MIN };
            assert_eq!(found >> 32, end as i128, "{what}");
        }
        let kept = (
            S::of_units(number(&mut random).max(-i32::MAX)),
            rest(&mut random),
        );
        let turned = S::reversed(kept);
        assert_eq!(fine_of(turned.0, turned.1), -fine_of(kept.0, kept.1));
    }
}

/// Two products, each half a unit of `2^-15` off.
fn check_kicked_as<S: Fine>() {
    let mut random = Random(23);
    for _ in 0..long(60_000) {
        let mut kept = || (S::of_units(number(&mut random)), rest(&mut random));
        let (v, value) = (kept(), kept());
        let factor = factor::<S>(&mut random);
        let found = S::kicked_as(v, value, factor);
        // What 128 bits do not hold is far beyond the range.
        let change = fine_of(value.0, value.1).saturating_mul(coef::<S>(factor));
        let exact = (fine_of(v.0, v.1) << 62).saturating_add(change);
        let what = format!("{v:?} {value:?} {factor:?}");
        if exact.saturating_abs() >> 62 < LIMIT - (1 << FINE) {
            let off = (fine_of(found.0, found.1) << 62) - exact;
            assert!(off.abs() <= 1 << 62, "{what}");
            let ends = [v.0, value.0].map(S::units).contains(&i32::MIN);
            let [mv, mvalue] = [v, value].map(|(v, rest)| (v.negated(), -rest));
            let back = S::kicked_as(mv, mvalue, factor);
            assert!(ends || back == (found.0.negated(), -found.1), "{what}");
        } else {
            let end = LIMIT - (1 << FINE);
            assert!(
                fine_of(found.0, found.1) * exact.signum() >= end - (1 << FINE),
                "{what}"
            );
        }
    }
}

fn check_all<S: Fine>() {
    check_beyond::<S>();
    check_mirrored::<S>();
    check_kicked_as::<S>();
}

#[test]
fn flows_see_all_of_a_place_in_i16f16() {
    check_all::<I16F16>();
}

#[test]
fn flows_see_all_of_a_place_in_i8f24() {
    check_all::<I8F24>();
}
