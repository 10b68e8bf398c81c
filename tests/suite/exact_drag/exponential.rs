//! `Decay::decay` against 126 bits, from `x = 2^-40` to `2^20`.
//!
//! Errors in roundings u. Fixed point, `u = 2^-30` of 1 (`2^-62`):
//!
//! ```text
//! y <= 1/2    each term of φ2 brings u/2 and its product u/2, halved each time      φ2   2 u
//!             φ1 = 1 - y φ2: half of that and u/2                                   φ1   1.5 u
//!             x φ1 is a product of coefficients: 1.5/0.78 + 0.5 relatively
//! doubling    loss: twice what was left over, and u/2: from 1.25 u at y = 1/2       loss 3.5 u
//!             φ1: (1 - loss/2) times, half of loss's, u: at most at the third       φ1   4.8 u
//!             φ2: half, half of φ1's, 1.4 u                                         φ2   6 u
//! y rounded   x off by u/2 for each of y's: (x/y) exp(-x)/2, at most 0.75 u
//! ```
//!
//! The loss is 0.39 or more where it was doubled: 6.2 u of it after the first. So 8 u of the loss, 8 u of
//! 1 for the others. From 64 on the inverse is rounded to u of itself, and 1 less it to half of u.
//!
//! Floats, u half a unit in the last place: 1.9, 2.1, 3.1 u relatively at y. A doubled loss rounds
//! three times, of which the inner two count half or less, and keeps `(2 - 2 l)/(2 - l)` of its error:
//! 5.2 u at most. φ1 takes on a share `l/(2 - l)` of the loss's error, and two roundings: 25 u after
//! seven. φ2 is a mean of itself and of twice φ1's error, and two roundings: 22 u.

use super::floats;
use super::reference::{Bits, decay};
use crate::support::{Format, Random, maximum, within};
use fixstep::fixed::types::{I8F24, I16F16, I16F48, I32F32};

/// `(m, k)` for `m / 2^k` from `2^-40` to `2^20`, rising: in each octave its corners, a half and
/// random ones; below and above 1/2 and 64; 63.9.
pub fn values<S: Bits>() -> Vec<(u64, u32)> {
    let (top, mut random) = (1_u64 << (S::MANTISSA - 1), Random(2));
    let mut all = vec![];
    for octave in -40..20_i32 {
        let k = (S::MANTISSA as i32 - 1 - octave) as u32;
        let cut = k.saturating_sub(S::LAST);
        let corners = [
            top,
            top + 1,
            top + 2,
            top + top / 2,
            2 * top - 2,
            2 * top - 1,
        ];
        let drawn = (0..24).map(|_| top | random.next() & (top - 1));
        all.extend(
            corners
                .into_iter()
                .chain(drawn)
                .map(|m| (m >> cut, k - cut)),
        );
    }
    let tenths = ((639_u128 << (S::MANTISSA - 6)) / 10) as u64;
    all.push((tenths, S::MANTISSA - 6));
    all.push((top, S::MANTISSA - 21));
    all.sort_by(|a, b| {
        (a.0 as f64 / 2_f64.powi(a.1 as i32)).total_cmp(&(b.0 as f64 / 2_f64.powi(b.1 as i32)))
    });
    all
}

/// Errors in roundings over what is allowed.
fn shares<S: Bits>(coefs: [S::Coef; 3], m: u64, k: u32) -> [f64; 3] {
    let (exact, got) = (decay(m, k), coefs.map(S::read));
    let beyond = m.checked_shr(k).unwrap_or(0) >= 64;
    let allowed = match (floats::<S>(), beyond) {
        (true, _) => [8.0, 32.0, 32.0].map(|u| (u, true)),
        (false, false) => [(8.0, true), (8.0, false), (8.0, false)],
        (false, true) => [8.0, 4.0, 4.0].map(|u| (u, true)),
    };
    std::array::from_fn(|i| {
        let off = got[i].abs_diff(exact[i]) as f64;
        let (roundings, relative) = allowed[i];
        let of = if relative {
            exact[i] as f64
        } else {
            super::reference::ONE as f64
        };
        off / (roundings * S::ROUNDING * of)
    })
}

fn report<S: Format>(what: &str, shares: &[[f64; 3]]) {
    for (i, name) in ["loss", "φ1", "φ2"].into_iter().enumerate() {
        let part: Vec<f64> = shares.iter().map(|share| share[i]).collect();
        within(
            1.0,
            &format!("{} {name}{what}, of its bound", S::name()),
            &part,
        );
    }
}

/// A loss that falls while x rises falls within the errors of both.
fn check<S: Bits>() {
    let (mut all, mut before) = (vec![], 0.0);
    for (m, k) in values::<S>() {
        let coefs = S::decay(S::make(m, k));
        all.push(shares::<S>(coefs, m, k));
        let loss = S::read(coefs[0]) as f64 / super::reference::ONE as f64;
        assert!(
            (0.0..=1.0).contains(&loss),
            "{} of {m}/2^{k}: {loss}",
            S::name()
        );
        assert!(
            loss >= before * (1.0 - 16.0 * S::ROUNDING),
            "{} of {m}/2^{k}",
            S::name()
        );
        before = maximum(&[before, loss]);
    }
    assert!(before == 1.0);
    report::<S>("", &all);
}

#[test]
fn decay_is_within_its_roundings() {
    check::<f32>();
    check::<f64>();
    check::<I16F16>();
    check::<I8F24>();
    check::<I32F32>();
    check::<I16F48>();
}

/// Of values as a state has them, whose mantissas have leading zeros.
fn check_plain<S: Bits>(fraction: u32, bits: u32, of_bits: impl Fn(i64) -> S) {
    let mut random = Random(3);
    let drawn = (0..bits).flat_map(|b| (0..16).map(move |i| (b, i)));
    let drawn = drawn
        .map(|(b, i)| 1 << b | if i < 2 { (1 << b) - i } else { random.next() } & ((1 << b) - 1));
    let shares = drawn.map(|m| shares::<S>(S::decay(of_bits(m as i64).coef()), m, fraction));
    report::<S>(" of a plain value", &shares.collect::<Vec<_>>());
}

#[test]
fn decay_takes_the_coefficient_of_a_state() {
    check_plain(16, 31, |bits| I16F16::from_bits(bits as i32));
    check_plain(24, 31, |bits| I8F24::from_bits(bits as i32));
    check_plain(32, 63, I32F32::from_bits);
    check_plain(48, 63, I16F48::from_bits);
}

/// Nothing is lost in no time, and no more than everything in the longest.
fn check_ends<S: Bits>() {
    let read =
        |coefs: [S::Coef; 3]| coefs.map(|c| S::read(c) as f64 / super::reference::ONE as f64);
    assert_eq!(read(S::decay(S::ZERO.coef())), [0.0, 1.0, 0.5]);
    let [loss, mean, mean_loss] = read(S::decay(S::MAX.coef()));
    assert!(loss == 1.0 && mean <= 1.0 / 64.0 && mean_loss <= mean);
}

#[test]
fn the_ends_of_the_range_are_the_ends_of_the_loss() {
    check_ends::<f32>();
    check_ends::<f64>();
    check_ends::<I16F16>();
    check_ends::<I8F24>();
    check_ends::<I32F32>();
    check_ends::<I16F48>();
}
