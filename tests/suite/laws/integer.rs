//! The exact results for a scalar that is an integer times `2^-FRACTION`, in 128 bits.

use std::fmt::Debug;

use fixstep::fixed::types::extra::{LeEqU32, LeEqU64};
use fixstep::fixed::{FixedI32, FixedI64};
use fixstep::scalar::Factor;
use fixstep::{Ratio, Scalar};

use crate::laws::judge::{Dyadic, Judge};

/// A scalar with `BITS` of storage.
pub trait Integer: Scalar {
    const BITS: u32;
    const FRACTION: u32;

    fn raw(self) -> i128;
    fn of_raw(raw: i128) -> Self;

    /// Up to 53 bits are exact in an `f64`.
    fn represented(factor: impl Factor<Self>) -> Dyadic {
        dyadic(factor.to_f64())
    }
}

/// A float as an integer over a power of two.
pub fn dyadic(value: f64) -> Dyadic {
    let (mut mantissa, mut shift) = (value, 0);
    while mantissa.trunc() != mantissa {
        (mantissa, shift) = (mantissa * 2.0, shift + 1);
    }
    Dyadic {
        mantissa: mantissa as i128,
        shift,
    }
}

/// A positive fraction, rounded to the nearest integer, ties away.
pub fn nearest(num: u128, den: u128) -> u128 {
    let (whole, rest) = (num / den, num % den);
    whole + u128::from(rest >= den - rest)
}

fn shifted(num: u128, shift: u32) -> u128 {
    let (whole, rest) = (num >> shift, num & ((1 << shift) - 1));
    whole + u128::from(shift > 0 && rest >> (shift - 1) == 1)
}

fn max<S: Integer>() -> i128 {
    (1 << (S::BITS - 1)) - 1
}

/// Limited to a range that can be negated.
fn signed<S: Integer>(negative: bool, magnitude: u128) -> S {
    let magnitude = magnitude.min(max::<S>() as u128) as i128;
    S::of_raw(if negative { -magnitude } else { magnitude })
}

/// Sign and magnitude of a dot product. Two products of 64 bits may need 127 for the magnitude.
fn dot<S: Integer>(a: [S; 2], b: [S; 2]) -> (bool, u128) {
    let [first, second] = [a[0].raw() * b[0].raw(), a[1].raw() * b[1].raw()];
    if (first < 0) == (second < 0) {
        return (first < 0, first.unsigned_abs() + second.unsigned_abs());
    }
    (first + second < 0, (first + second).unsigned_abs())
}

/// Judges every [`Integer`].
pub struct Integers;

impl<S: Integer> Judge<S> for Integers {
    fn corners() -> Vec<S> {
        let max = max::<S>();
        let one = 1 << S::FRACTION;
        let corners = [
            -max - 1,
            -max,
            -1,
            0,
            1,
            max - 1,
            max,
            -one,
            one,
            max / 2,
            max / 2 + 1,
        ];
        corners
            .into_iter()
            .filter(|raw| (-max - 1..=max).contains(raw))
            .map(S::of_raw)
            .collect()
    }

    fn any(bits: u64) -> S {
        S::of_raw((bits as i64 >> (64 - S::BITS) >> (bits % 64).min(S::BITS as u64 - 2)).into())
    }

    fn has_negative(a: S) -> bool {
        a.raw() >= -max::<S>()
    }

    fn is_inside(a: S) -> bool {
        a.raw().abs() < max::<S>()
    }

    fn sum(a: S, b: S) -> S {
        S::of_raw((a.raw() + b.raw()).clamp(-max::<S>() - 1, max::<S>()))
    }

    fn difference(a: S, b: S) -> S {
        S::of_raw((a.raw() - b.raw()).clamp(-max::<S>() - 1, max::<S>()))
    }

    fn product(a: S, b: S) -> S {
        let product = a.raw() * b.raw();
        signed(product < 0, shifted(product.unsigned_abs(), S::FRACTION))
    }

    fn scaled(factor: Dyadic, a: S) -> S {
        let product = a.raw() * factor.mantissa;
        signed(product < 0, shifted(product.unsigned_abs(), factor.shift))
    }

    fn dot(a: [S; 2], b: [S; 2]) -> S {
        let (negative, magnitude) = dot(a, b);
        signed(negative, shifted(magnitude, S::FRACTION))
    }

    // A sum beyond the square of the range may be kept as that square: it saturates in any case.
    fn quotient(a: [S; 2], b: [S; 2], divisor: S) -> S {
        if divisor.raw() <= 0 {
            return S::ZERO;
        }
        let (negative, magnitude) = dot(a, b);
        signed(negative, nearest(magnitude, divisor.raw() as u128))
    }

    // r - 1/2 < sqrt(s) < r + 1/2, squared, in integers
    fn is_length(v: [S; 2], length: S) -> bool {
        let square = dot(v, v).1;
        let r = length.raw() as u128;
        let low_enough = r == 0 || r * r - r < square;
        let high_enough = square <= r * r + r || length.raw() == max::<S>();
        length.raw() >= 0 && low_enough && high_enough
    }

    // -MAX - 1 is left out: what a constructor makes can be negated.
    fn is_ratio(ratio: Ratio, value: Option<S>) -> bool {
        let num = u128::from(ratio.num().unsigned_abs()) << S::FRACTION;
        let magnitude = nearest(num, ratio.den().into());
        if magnitude > max::<S>() as u128 {
            return value.is_none();
        }
        value.map(S::raw) == Some(signed::<S>(ratio.num() < 0, magnitude).raw())
    }

    fn represented(factor: impl Factor<S>) -> Dyadic {
        S::represented(factor)
    }
}

impl<F: LeEqU32> Integer for FixedI32<F> {
    const BITS: u32 = 32;
    const FRACTION: u32 = F::U32;

    fn raw(self) -> i128 {
        self.to_bits().into()
    }

    fn of_raw(raw: i128) -> Self {
        FixedI32::from_bits(raw.try_into().unwrap())
    }
}

impl<F: LeEqU64> Integer for FixedI64<F> {
    const BITS: u32 = 64;
    const FRACTION: u32 = F::U32;

    fn raw(self) -> i128 {
        self.to_bits().into()
    }

    fn of_raw(raw: i128) -> Self {
        FixedI64::from_bits(raw.try_into().unwrap())
    }

    fn represented(factor: impl Factor<Self>) -> Dyadic {
        let exact = printed(factor);
        let double = exact.mantissa as f64 / 2.0_f64.powi(exact.shift as i32);
        assert!(
            (double - factor.to_f64()).abs() <= 1e-15 * double.abs(),
            "{factor:?}"
        );
        exact
    }
}

/// 62 bits do not fit an `f64`, so they are read from what `Debug` prints.
pub fn printed(factor: impl Debug) -> Dyadic {
    let text = format!("{factor:?}");
    let numbers: Vec<i128> = text
        .split(|c: char| !c.is_ascii_digit() && c != '-')
        .filter_map(|word| word.parse().ok())
        .collect();
    match (text.split([' ', '(']).next(), numbers.as_slice()) {
        (Some("Coef"), [mantissa, shift]) => Dyadic {
            mantissa: *mantissa,
            shift: *shift as u32,
        },
        (Some("Span"), [mantissa, shift]) => Dyadic {
            mantissa: *mantissa,
            shift: 64 + *shift as u32,
        },
        (Some("InvMass"), [packed]) => Dyadic {
            mantissa: packed & !31,
            shift: 52 + (packed & 31) as u32,
        },
        (Some("Times"), [mantissa]) => Dyadic {
            mantissa: *mantissa,
            shift: 40,
        },
        _ => panic!("no factor that is known here: {text}"),
    }
}
