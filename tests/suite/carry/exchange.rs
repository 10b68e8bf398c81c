//! A push for itself: random states, impulses and masses over the whole range. The momentum changes
//! by exactly the impulse, and the velocity by what the impulse is worth.

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{Body, Factor, Scalar};

use super::bits::{FINE, Fine, LIMIT, fine_of, mass, rounded};
use crate::support::*;

type Kept<S> = (S, i16);

/// Units of momentum of a fine velocity, `2^(15 - shift)` units of the type's each.
fn units(fine: i128, mass: i128) -> i128 {
    rounded(fine * mass, 30)
}

/// What an impulse is in those: exact up to `2^15` kg, else nearest.
fn gained(impulse: i32, shift: u32) -> i128 {
    match shift.checked_sub(FINE) {
        Some(up) => (impulse as i128) << up,
        None => rounded(impulse.into(), FINE - shift),
    }
}

/// Numbers of all sizes: up to `bits` bits, of either sign, and now and then the ends.
fn number(random: &mut Random, bits: u32) -> i32 {
    let word = random.next();
    let magnitude = (word >> 33) as i32 >> (31 - bits + word as u32 % (bits + 1)).min(31);
    match word >> 8 & 0xFF {
        0 => i32::MAX,
        1 => -i32::MAX,
        2 => i32::MIN,
        3 => 0,
        _ if word & 0x1_0000 == 0 => magnitude,
        _ => -magnitude,
    }
}

/// From just above `2^-11` to `2^21` kg.
fn inv_mass<S: Scalar>(random: &mut Random) -> S::InvMass {
    let exponent = (random.next() % 32) as i32 - 21;
    let mantissa = 1.0 + (random.next() >> 12) as f64 / 2.0_f64.powi(52);
    let inverse = mantissa * 2.0_f64.powi(exponent);
    S::InvMass::new(ratio(inverse.min(2047.99))).unwrap()
}

fn state<S: Fine>(random: &mut Random) -> Kept<S> {
    let rest = (random.next() % ((1 << FINE) + 1)) as i32 - (1 << (FINE - 1));
    (S::of_units(number(random, 31)), rest as i16)
}

fn push<S: Fine>(kept: Kept<S>, impulse: i32, inv_mass: S::InvMass) -> Kept<S> {
    let [pushed, still] = S::pushed([kept, kept], [S::of_units(impulse), S::ZERO], inv_mass);
    let (v, rest) = (fine_of(kept.0, kept.1), fine_of(still.0, still.1));
    assert!(v == rest || v.abs() > LIMIT, "no impulse, another velocity");
    pushed
}

fn negated<S: Fine>((v, rest): Kept<S>) -> Kept<S> {
    (v.negated(), -rest)
}

#[derive(Default, Debug)]
struct Met {
    exact: u32,
    saturated: u32,
    heavy: u32,
}

fn check<S: Fine>(kept: Kept<S>, impulse: i32, inv_mass: S::InvMass, met: &mut Met) {
    let (m, shift) = mass::<S>(inv_mass);
    let (v, rest) = push(kept, impulse, inv_mass);
    let (before, after) = (fine_of(kept.0, kept.1), fine_of(v, rest));
    let wanted = units(before, m) + gained(impulse, shift);
    let what = || format!("{kept:?} {impulse} {inv_mass:?}: {after}");
    assert!(rest.unsigned_abs() <= 1 << (FINE - 1), "{}", what());
    let end = units(LIMIT, m);
    if wanted.abs() < end {
        assert_eq!(units(after, m), wanted, "{}", what());
        met.exact += 1;
    } else {
        // At the end of the range or what is left of a remainder beyond it.
        assert!(after * wanted.signum() >= LIMIT - (1 << FINE), "{}", what());
        met.saturated += 1;
    }
    // The smallest number (of the lower end) has no opposite.
    let ends = [kept.0.units(), impulse, v.units()];
    if !ends.contains(&i32::MIN) && wanted.abs() < end {
        let mirrored = push(negated(kept), -impulse, inv_mass);
        assert_eq!(mirrored, negated((v, rest)), "{}", what());
    }
    if shift < FINE {
        // Rounded to a unit of momentum, of which half is at most one of the remainder's.
        let off = (units(after, m) - units(before, m)) * (1 << (FINE - shift)) - impulse as i128;
        assert!(wanted.abs() >= end || 2 * off.abs() <= 1 << (FINE - shift));
        met.heavy += 1;
    }
}

fn check_all<S: Fine>(seed: u64) {
    let (mut random, mut met) = (Random(seed), Met::default());
    for _ in 0..long(100_000) {
        let (kept, impulse) = (state::<S>(&mut random), number(&mut random, 31));
        check(kept, impulse, inv_mass::<S>(&mut random), &mut met);
    }
    println!("{} {met:?}", S::name());
    let least = |count| long(count) as usize;
    assert!(met.exact as usize > least(50_000));
    assert!(met.saturated as usize > least(5_000) && met.heavy as usize > least(10_000));
}

#[test]
fn impulses_at_random_are_exchanged_exactly() {
    check_all::<I16F16>(1);
}

#[test]
fn impulses_at_random_are_exchanged_exactly_in_i8f24() {
    check_all::<I8F24>(2);
}

#[test]
fn the_corners_of_an_impulse() {
    let mut met = Met::default();
    let ends = [i32::MIN, -i32::MAX, -1, 0, 1, i32::MAX - 1, i32::MAX];
    let rests = [-(1 << 14), -1, 0, 1, 1 << 14];
    let powers = (-21..11).map(|e| 2.0_f64.powi(e));
    let near = powers.flat_map(|power| [power, power * 1.5, power * (2.0 - 2.0_f64.powi(-20))]);
    for inverse in near {
        let inv_mass = <<I16F16 as Scalar>::InvMass as Factor<I16F16>>::new(ratio(inverse));
        let inv_mass = inv_mass.unwrap();
        for (v, rest) in ends.iter().flat_map(|&v| rests.map(|rest| (v, rest))) {
            for impulse in ends {
                check((I16F16::of_units(v), rest), impulse, inv_mass, &mut met);
            }
        }
    }
    assert!(met.exact > 1000 && met.saturated > 1000);
}

/// By hand: 3 units of impulse on 2 kg are 1.5 units of velocity, on 3 kg one.
#[test]
fn impulses_by_hand() {
    let push = |impulse, kilograms: f64| {
        let mut body = fixstep::Carried::from(point::<I16F16>([0.0; 2], [0.0; 2], kilograms));
        body.push(fixstep::Vec2::new(I16F16::of_units(impulse), I16F16::ZERO));
        super::bits::fine(&body)
    };
    assert_eq!(push(3, 2.0), [3 << 14, 0]);
    assert_eq!(push(3, 3.0), [1 << 15, 0]);
    assert_eq!(push(-3, 4.0), [-(3 << 13), 0]);
    assert_eq!(push(1, 32768.0), [1, 0]);
}
