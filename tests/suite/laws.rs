//! Every number type that comes with the crate keeps the number law.

#[path = "laws/float.rs"]
pub mod float;
#[path = "laws/integer.rs"]
pub mod integer;
#[path = "laws/judge.rs"]
pub mod judge;
#[path = "laws/precision.rs"]
mod precision;
#[path = "laws/verbs.rs"]
pub mod verbs;
#[path = "laws/verbs_built_in.rs"]
mod verbs_built_in;

use crate::support::long;
use fixstep::Scalar;
use fixstep::fixed::types::{I1F31, I1F63, I8F24, I12F20, I16F16, I20F12, I32F32};
use float::Floats;
use integer::Integers;
use judge::{corners, pairs, ratios, values};

/// Random pairs for each number type.
const PAIRS: u64 = long(1_000_000);

macro_rules! laws_of {
    ($($name:ident: $scalar:ty, $judge:ty;)*) => {$(
        mod $name {
            use super::*;

            #[test]
            fn corners_keep_the_law() {
                corners::<$scalar, $judge>();
            }

            #[test]
            fn pairs_keep_the_law() {
                pairs::<$scalar, $judge>(PAIRS);
            }

            #[test]
            fn values_keep_the_law() {
                values::<$scalar, $judge>(PAIRS / 10);
            }

            #[test]
            fn ratios_are_rounded_once() {
                ratios::<$scalar, $judge>(20_000);
            }
        }
    )*};
}

laws_of! {
    f32_: f32, Floats;
    f64_: f64, Floats;
    i16f16: I16F16, Integers;
    i12f20: I12F20, Integers;
    i8f24: I8F24, Integers;
    i20f12: I20F12, Integers;
    i1f31: I1F31, Integers;
    i32f32: I32F32, Integers;
    i1f63: I1F63, Integers;
}

macro_rules! precision_of {
    ($($name:ident: $scalar:ty, $judge:ty;)*) => {$(
        mod $name {
            use super::*;

            #[test]
            fn coefficients_are_off_by_half_a_unit() {
                precision::relative::<<$scalar as Scalar>::Coef, $scalar, $judge>(31, 20_000);
            }

            #[test]
            fn spans_are_off_by_one_unit() {
                precision::spans::<$scalar, $judge>(20_000);
            }

            #[test]
            fn inverse_masses_are_off_by_half_a_unit() {
                precision::relative::<<$scalar as Scalar>::InvMass, $scalar, $judge>(26, 20_000);
            }

            #[test]
            fn products_of_coefficients_are_rounded_once() {
                precision::products::<$scalar>(20_000);
            }

            #[test]
            fn gains_sum_to_the_rate() {
                precision::gains_sum::<$scalar, $judge>(3_000);
            }

            #[test]
            fn gains_sum_to_the_rate_from_any_tick() {
                precision::gains_from_any_tick::<$scalar>();
            }

            #[test]
            fn gains_are_odd() {
                precision::gains_are_odd::<$scalar, $judge>(20_000);
            }
        }
    )*};
}

mod factors {
    use super::*;

    precision_of! {
        i16f16: I16F16, Integers;
        i8f24: I8F24, Integers;
        i20f12: I20F12, Integers;
        i32f32: I32F32, Integers;
    }
}

#[test]
fn a_float_gains_the_same_in_every_tick() {
    for tick in [0, 1, 59, u64::MAX] {
        assert_eq!(
            f32::gained(Scalar::gain(-9.81_f32, 1.0 / 60.0), tick),
            -9.81 * (1.0 / 60.0)
        );
        assert_eq!(
            f64::gained(Scalar::gain(-9.81_f64, 1.0 / 60.0), tick),
            -9.81 * (1.0 / 60.0)
        );
    }
}

#[test]
fn one_nan_and_one_zero() {
    let nans = [
        0x7FC0_0000,
        0xFFC0_0000,
        0x7FC0_0001,
        0x7F80_0001,
        0xFFFF_FFFF,
    ];
    float::canonical(&nans.map(f32::from_bits), &[0.0, -0.0]);
    let nans = [
        0x7FF8 << 48,
        0xFFF8 << 48,
        0x7FF8 << 48 | 1,
        0x7FF0 << 48 | 1,
        u64::MAX,
    ];
    float::canonical(&nans.map(f64::from_bits), &[0.0, -0.0]);
    assert_eq!(Scalar::bits(1.5_f32), u64::from(1.5_f32.to_bits()));
    assert_eq!(Scalar::bits(-1.5_f64), (-1.5_f64).to_bits());
}
