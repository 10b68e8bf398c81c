//! The verbs of gravitation and quadratic drag in every number type that comes with the crate.

use fixstep::Scalar;
use fixstep::fixed::types::{I1F31, I1F63, I8F24, I12F20, I16F16, I20F12, I32F32};
use fixstep::scalar::{Factor, Stored};

use crate::laws::float::Floats;
use crate::laws::integer::{Integers, dyadic};
use crate::laws::judge::Random;
use crate::laws::verbs::{coefs, even, inverse_lengths, is_inverse_root, masses, with_bits};
use crate::support::LAB;

const COUNT: u64 = if LAB { 200_000 } else { 10_000 };

macro_rules! verbs_of {
    ($($name:ident: $scalar:ty, $bits:literal;)*) => {$(
        #[test]
        fn $name() {
            inverse_lengths::<$scalar>($bits, COUNT);
            masses::<$scalar, Integers>($bits - 1, COUNT);
            coefs::<$scalar, Integers>(COUNT);
        }
    )*};
}

verbs_of! {
    i16f16: I16F16, 31;
    i12f20: I12F20, 31;
    i8f24: I8F24, 31;
    i20f12: I20F12, 31;
    i1f31: I1F31, 31;
    i32f32: I32F32, 63;
    i1f63: I1F63, 63;
}

/// All `2^25` mantissas of an inverse mass, and all 32 places of its point: every 32-bit fixed point
/// shares them.
#[test]
fn every_legal_inverse_mass() {
    let mass = |packed: u64| {
        let inverse = <I16F16 as Scalar>::InvMass::restore(packed).unwrap();
        Factor::<I16F16>::to_f64(I16F16::mass(inverse))
    };
    for mantissa in (1_u64 << 30..1 << 31).step_by(32) {
        // `e` of 10 is the inverse mass `m / 2^30`; 30 bits are kept.
        let reciprocal = ((1 << 60) + mantissa / 2) / mantissa;
        assert_eq!(
            mass(mantissa | 10),
            reciprocal as f64 / (1_u64 << 30) as f64
        );
    }
    for mantissa in (1_u64 << 30..1 << 31)
        .step_by(32 * 9973)
        .chain([(1 << 31) - 32])
    {
        let middle = mass(mantissa | 10);
        for e in 0..32 {
            assert_eq!(mass(mantissa | e), middle * 2.0_f64.powi(e as i32 - 10));
        }
    }
}

#[test]
fn masses_and_coefficients_of_floats() {
    masses::<f32, Floats>(24, COUNT);
    masses::<f64, Floats>(53, COUNT);
    coefs::<f32, Floats>(COUNT);
    coefs::<f64, Floats>(COUNT);
}

/// Squares and two sums, half a unit each, which the root halves; root and quotient: 1.75 epsilon,
/// at most 3.5 units of the last of `digits` places. Whole numbers, so that their squares are known.
macro_rules! float_inverse_lengths {
    ($name:ident, $float:ident) => {
        #[test]
        fn $name() {
            const DIGITS: u32 = $float::MANTISSA_DIGITS;
            let mut random = Random(DIGITS.into());
            for i in 0..200_000 {
                let part = |any: u64| any >> (64 - DIGITS) >> (any % u64::from(DIGITS));
                let mut whole = [(); 3].map(|_| part(random.next()));
                whole[2] *= i % 2;
                let q = whole.iter().map(|&s| u128::from(s) * u128::from(s)).sum();
                let [x, y, s] = whole.map(|s| s as $float);
                even::<$float, Floats>([x, y], s);
                let got = Scalar::inverse_length([x, y], s);
                let inverse = with_bits(dyadic(got.into()), DIGITS);
                let right = got == 0.0 && q == 0 || is_inverse_root(q, inverse, 4, false);
                assert!(right, "{x} {y} {s} gave {got}");
                let scaled = [x, y, s].map(|s| s / 1024.0);
                let other: $float = Scalar::inverse_length([scaled[0], scaled[1]], scaled[2]);
                assert_eq!(other, got * 1024.0);
            }
            let (zero, max): ($float, _) = (0.0, $float::MAX);
            assert_eq!(Scalar::inverse_length([-zero, zero], zero), zero);
            assert_eq!(Scalar::inverse_length([max, max], zero), zero);
            let lost: $float = Scalar::inverse_length([$float::NAN, zero], zero);
            assert!(lost.is_nan());
        }
    };
}

float_inverse_lengths!(inverse_lengths_of_f32, f32);
float_inverse_lengths!(inverse_lengths_of_f64, f64);
