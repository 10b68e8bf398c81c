//! `Decay::share`, `q / (1 + q)`, against 126 bits.
//!
//! In fixed point the divisor is cut to u of itself, and the quotient, at least a half of 1, rounds by
//! half a unit of `2^-30`: 2 u relatively, whatever q is. Floats round three times from q = 1 on,
//! the first counted half, and twice below: 2.5 u.

use super::exponential::values;
use super::reference::{Bits, ONE, share};
use crate::support::{Random, maximum, within};
use fixstep::fixed::types::{I8F24, I16F16, I16F48, I20F12, I32F32};
use fixstep::{Decay, Scalar};

/// What a share may be off, in roundings of itself; reading one of 64 bits adds half of one.
const ROUNDINGS: f64 = 3.0;

fn off<S: Bits>(coef: S::Coef, m: u64, k: u32) -> f64 {
    let (got, exact) = (S::read(coef), share(m, k));
    assert!(got <= ONE, "{} of {m}/2^{k}", S::name());
    got.abs_diff(exact) as f64 / (ROUNDINGS * S::ROUNDING * exact as f64)
}

fn check<S: Bits>() {
    let (mut all, mut before) = (vec![], 0.0);
    for (m, k) in values::<S>() {
        let coef = S::share(S::make(m, k));
        all.push(off::<S>(coef, m, k));
        let now = S::read(coef) as f64;
        assert!(now >= before * (1.0 - 2.0 * ROUNDINGS * S::ROUNDING));
        before = maximum(&[before, now]);
    }
    within(1.0, &format!("{} share, of its bound", S::name()), &all);
}

#[test]
fn share_is_within_its_roundings() {
    check::<f32>();
    check::<f64>();
    check::<I16F16>();
    check::<I8F24>();
    check::<I32F32>();
    check::<I16F48>();
}

/// Of values as a state has them, whose mantissas have leading zeros.
fn check_plain<S: Bits>(fraction: u32, bits: u32, of_bits: impl Fn(i64) -> S) {
    let mut random = Random(5);
    let mut all = vec![];
    for b in 0..bits {
        for i in 0..16 {
            let low = if i < 2 { (1 << b) - i } else { random.next() };
            let m = 1 << b | low & ((1 << b) - 1);
            all.push(off::<S>(S::share(of_bits(m as i64).coef()), m, fraction));
        }
    }
    within(1.0, &format!("{} share of a plain value", S::name()), &all);
}

#[test]
fn share_takes_the_coefficient_of_a_state() {
    check_plain(16, 31, |bits| I16F16::from_bits(bits as i32));
    check_plain(24, 31, |bits| I8F24::from_bits(bits as i32));
    check_plain(32, 63, I32F32::from_bits);
    check_plain(48, 63, I16F48::from_bits);
}

#[test]
fn no_drag_takes_no_share() {
    assert_eq!(
        I20F12::share(I20F12::ZERO.coef()),
        I20F12::share(I20F12::MIN.coef())
    );
    assert_eq!(I16F16::read(I16F16::share(I16F16::ZERO.coef())), 0);
    assert_eq!(f32::share(0.0), 0.0);
    assert_eq!(f64::share(0.0), 0.0);
    assert_eq!(f32::share(f32::MAX), 1.0);
}
