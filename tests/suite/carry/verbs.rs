//! The verbs of fixed point beside their definitions in 128-bit integers: nearest, odd, saturating,
//! total. These tests run with overflow checks.

use fixstep::Factor;
use fixstep::fixed::types::{I8F24, I16F16, I20F12};

use super::bits::{FINE, Fine, LIMIT, coef, fine_of, rounded};
use crate::support::*;

const ENDS: [i32; 9] = [
    i32::MIN,
    -i32::MAX,
    -(1 << 30),
    -1,
    0,
    1,
    1 << 30,
    i32::MAX - 1,
    i32::MAX,
];

/// A number of any size, often an end.
pub fn number(random: &mut Random) -> i32 {
    let word = random.next();
    match word % 4 {
        0 => ENDS[(word >> 8) as usize % ENDS.len()],
        _ => (word >> 32) as i32 >> (word >> 8 & 31),
    }
}

pub fn rest(random: &mut Random) -> i16 {
    let half = 1 << (FINE - 1);
    match random.next() % 4 {
        0 => [-half, -1, 0, 1, half][(random.next() % 5) as usize] as i16,
        _ => ((random.next() % (2 * half as u64 + 1)) as i32 - half) as i16,
    }
}

/// Coefficients from `2^-31` to `2^30`, some of them powers of two.
pub fn factor<S: Fine>(random: &mut Random) -> S::Coef {
    let exponent = (random.next() % 61) as i32 - 31;
    let mantissa = match random.next() % 4 {
        0 => 1.0,
        _ => 1.0 + (random.next() >> 34) as f64 / 2.0_f64.powi(30),
    };
    let sign = if random.next().is_multiple_of(2) {
        1.0
    } else {
        -1.0
    };
    S::Coef::new(ratio(sign * mantissa * 2.0_f64.powi(exponent))).unwrap()
}

/// What a place shows, in units.
fn seen(place: i128) -> i128 {
    rounded(place, 32).clamp(i32::MIN.into(), i32::MAX.into())
}

fn check_seen<S: Fine>() {
    let mut random = Random(3);
    let halves = [0, 1, (1 << 31) - 1, 1 << 31, (1 << 31) + 1, u32::MAX];
    for i in 0..long(200_000) {
        let low = match i % 2 {
            0 => halves[(random.next() % 6) as usize],
            _ => random.next() as u32,
        };
        let place = (number(&mut random) as i64) << 32 | low as i64;
        let shown = S::seen(place);
        assert_eq!(shown.units() as i128, seen(place.into()), "{place:#x}");
        if (place >> 32).abs() < i64::from(i32::MAX) {
            assert!(S::seen(-place) == shown.negated(), "{place:#x}");
        }
        assert!(S::from_halves(S::halves(place)) == Some(place));
        assert_eq!(S::left_over(place), u64::from(low));
    }
    assert!(S::seen(i64::MAX) == S::MAX);
    assert_eq!(S::seen(i64::MIN).units(), i32::MIN);
    for units in ENDS {
        let place = S::of_units(units).fine_position();
        assert_eq!(
            (place, S::seen(place).units()),
            ((units as i64) << 32, units)
        );
    }
}

/// Where the change leaves the range the place saturates; the part that is not seen may be any.
fn assert_place<S: Fine>(found: i64, exact: i128, off: i128, what: &str) {
    let range = i64::MIN as i128..=i64::MAX as i128;
    if range.contains(&(exact + off)) && range.contains(&(exact - off)) {
        assert!(
            (found as i128 - exact).abs() <= off,
            "{what}: {found} {exact}"
        );
    } else {
        let end = if exact > 0 { i32::MAX } else { i32::MIN };
        let shown = S::seen(found).units();
        assert!(shown.abs_diff(end) <= 1, "{what}: {found} {exact}");
    }
}

fn check_moved<S: Fine>() {
    let mut random = Random(5);
    for _ in 0..long(60_000) {
        let place = (number(&mut random) as i64) << 32 | random.next() as u32 as i64;
        let (value, factor) = (S::of_units(number(&mut random)), factor::<S>(&mut random));
        for halvings in [0, 1] {
            let found = S::moved(place, value, factor, halvings);
            // coef is m 2^-62, the place counts 2^-32. Half of it for the rounding; the odd fraction
            // moves the product by 2^31 2^-32 more.
            let change = value.units() as i128 * coef::<S>(factor);
            // The change saturates before it is added, as that of a point does.
            let change =
                rounded(change, 30 + halvings).clamp(-i128::from(i64::MAX), i64::MAX.into());
            let exact = place as i128 + change;
            let what = format!("{value:?} {factor:?} {halvings}");
            assert_place::<S>(found, exact, 1, &what);
            let inside = found.unsigned_abs() < i64::MAX as u64 >> 1;
            if inside && place != i64::MIN && value.units() != i32::MIN {
                let mirrored = S::moved(-place, value.negated(), factor, halvings);
                assert_eq!(mirrored, -found, "{what}");
            }
        }
    }
}

fn check_dyadic<S: Fine, const NUM: u32, const SHIFT: u32>() {
    let mut random = Random(7);
    for i in 0..long(50_000) {
        let low = if i % 2 == 0 { 0 } else { random.next() as u32 };
        let place = (number(&mut random) as i64) << 32 | low as i64;
        let value = S::of_units(number(&mut random));
        let found = S::moved_dyadic(place, value, NUM, SHIFT);
        let change = (value.units() as i128 * NUM as i128) << (32 - SHIFT);
        let change = change.clamp(i64::MIN.into(), i64::MAX.into());
        let what = format!("{value:?} {NUM} {SHIFT}");
        assert_place::<S>(found, place as i128 + change, 0, &what);
    }
}

fn check_kicked<S: Fine>() {
    let mut random = Random(11);
    for _ in 0..long(60_000) {
        let kept = (S::of_units(number(&mut random)), rest(&mut random));
        let (value, factor) = (S::of_units(number(&mut random)), factor::<S>(&mut random));
        let (v, left) = S::kicked(kept, value, factor);
        let change = rounded(value.units() as i128 * coef::<S>(factor), 62 - FINE);
        let exact = fine_of(kept.0, kept.1) + change;
        let what = format!("{kept:?} {value:?} {factor:?}");
        assert!(left.unsigned_abs() <= 1 << (FINE - 1), "{what}");
        if exact.abs() < LIMIT - (1 << FINE) {
            assert_eq!(fine_of(v, left), exact, "{what}");
            if ![kept.0, value].map(S::units).contains(&i32::MIN) {
                let back = S::kicked((kept.0.negated(), -kept.1), value.negated(), factor);
                assert_eq!(back, (v.negated(), -left), "{what}");
            }
        } else {
            let end = LIMIT - (1 << FINE);
            assert!(fine_of(v, left) * exact.signum() >= end, "{what}");
        }
    }
}

/// A loss from 0 to 1, with small ones and the ends.
fn loss<S: Fine>(random: &mut Random) -> S::Coef {
    let part = (random.next() >> 12) as f64 / 2.0_f64.powi(52);
    let loss = match random.next() % 8 {
        0 => 0.0,
        1 => 1.0,
        2 => 1.0 - 2.0_f64.powi(-30),
        _ => part * 2.0_f64.powi(-((random.next() % 31) as i32)),
    };
    S::Coef::new(ratio(loss)).unwrap_or(S::Coef::new(ratio(0.0)).unwrap())
}

fn check_damped<S: Fine>() {
    let mut random = Random(13);
    for _ in 0..long(60_000) {
        let kept = (S::of_units(number(&mut random)), rest(&mut random));
        let (before, loss) = (fine_of(kept.0, kept.1), loss::<S>(&mut random));
        // A sum at the end of the range may leave its remainder beyond it; the next cuts it off.
        if before.abs() > LIMIT {
            continue;
        }
        let (v, left) = S::damped(kept, loss);
        let (after, part) = (fine_of(v, left), coef::<S>(loss));
        let what = format!("{kept:?} {loss:?}: {after}");
        // Two products, each half a unit off; or a whole one, so that it comes to rest.
        let off = ((before - after) << 62) - before * part;
        assert!(off.abs() <= 1 << 62, "{what}");
        assert!(
            after * before.signum() >= 0 && after.abs() <= before.abs(),
            "{what}"
        );
        assert!((after == before) == (part == 0 || before == 0), "{what}");
        if before.abs() < LIMIT {
            let back = S::damped((kept.0.negated(), -kept.1), loss);
            assert_eq!(back, (v.negated(), -left), "{what}");
        }
    }
}

/// The slowest loss there is brings any body to rest: its last unit goes.
fn check_rest<S: Fine>() {
    let loss = S::Coef::new(ratio(2.0_f64.powi(-31))).unwrap();
    for (v, rest) in [(1, 77), (-1, 0), (0, -5)] {
        let mut kept = (S::of_units(v), rest);
        for _ in 0..=fine_of(kept.0, kept.1).abs() {
            kept = S::damped(kept, loss);
        }
        assert_eq!(kept, (S::ZERO, 0));
    }
}

fn check_bits<S: Fine>() {
    for bits in 0..=u16::MAX {
        let rest = S::from_remainder_bits(bits.into());
        let holds = (bits as i16).unsigned_abs() <= 1 << (FINE - 1);
        assert_eq!(rest, holds.then_some(bits as i16));
        assert!(rest.is_none_or(|rest| S::remainder_bits(rest) == u64::from(bits)));
    }
    assert_eq!(S::from_remainder_bits(1 << 16), None);
    assert_eq!(S::from_halves([1 << 32, 0]), None);
    assert_eq!(S::from_halves([0, 1 << 32]), None);
}

fn check_all<S: Fine>() {
    check_seen::<S>();
    check_moved::<S>();
    check_dyadic::<S, 1, 0>();
    check_dyadic::<S, 1, 6>();
    check_dyadic::<S, 4389, 18>();
    check_dyadic::<S, 16_777_216, 25>();
    check_dyadic::<S, 16_777_216, 2>();
    check_dyadic::<S, 1, 30>();
    check_kicked::<S>();
    check_damped::<S>();
    check_rest::<S>();
    check_bits::<S>();
}

#[test]
fn verbs_are_what_integers_say_in_i16f16() {
    check_all::<I16F16>();
}

#[test]
fn verbs_are_what_integers_say_in_i8f24() {
    check_all::<I8F24>();
}

#[test]
fn verbs_are_what_integers_say_in_i20f12() {
    check_all::<I20F12>();
}
