//! The exact results for `f32` and `f64`.
//!
//! A product of two `f32` is exact in `f64`, so converting it rounds once. For `f64` the operators
//! of IEEE 754 are the definition: separate, none fused.

use fixstep::scalar::Factor;
use fixstep::{Ratio, Scalar};

use crate::laws::integer::dyadic;
use crate::laws::judge::{Dyadic, Judge};

/// Judges `f32` and `f64`.
pub struct Floats;

fn product_f32(a: f32, b: f32) -> f32 {
    (a as f64 * b as f64) as f32
}

fn product_f64(a: f64, b: f64) -> f64 {
    a * b
}

/// `|value - num / den|` at most half a unit in the last of `digits` places.
fn is_nearest(value: f64, digits: i32, ratio: Ratio) -> bool {
    if ratio.num() == 0 {
        return value == 0.0;
    }
    let half_unit = (value.to_bits() >> 52 & 0x7FF) as i32 - 1023 - digits;
    let (num, den) = (i128::from(ratio.num()), i128::from(ratio.den()));
    let exact = dyadic(value);
    let shift = exact.shift.max((-half_unit).max(0) as u32);
    let error = ((exact.mantissa * den) << (shift - exact.shift)) - (num << shift);
    error.abs() <= den << (shift as i32 + half_unit)
}

macro_rules! judge {
    ($float:ident, $product:ident) => {
        impl Judge<$float> for Floats {
            fn corners() -> Vec<$float> {
                let tiny = $float::from_bits(1);
                let subnormal = $float::MIN_POSITIVE / 2.0;
                let positive = [
                    0.0,
                    tiny,
                    subnormal,
                    $float::MIN_POSITIVE,
                    1.0,
                    1.5,
                    $float::EPSILON,
                    $float::MAX.next_down(),
                    $float::MAX,
                    $float::INFINITY,
                    $float::NAN,
                ];
                positive.into_iter().flat_map(|x| [x, -x]).collect()
            }

            fn any(bits: u64) -> $float {
                const SPARE: u32 = 64 - 8 * size_of::<$float>() as u32;
                $float::from_bits((bits >> SPARE) as _)
            }

            fn has_negative(_: $float) -> bool {
                true
            }

            fn is_inside(a: $float) -> bool {
                a.abs() < $float::INFINITY
            }

            fn sum(a: $float, b: $float) -> $float {
                a + b
            }

            fn difference(a: $float, b: $float) -> $float {
                a - b
            }

            fn product(a: $float, b: $float) -> $float {
                $product(a, b)
            }

            fn scaled(factor: Dyadic, a: $float) -> $float {
                $product(
                    factor.mantissa as $float / 2.0_f64.powi(factor.shift as i32) as $float,
                    a,
                )
            }

            // Three roundings: no wider type, and no fused operation.
            fn dot(a: [$float; 2], b: [$float; 2]) -> $float {
                $product(a[0], b[0]) + $product(a[1], b[1])
            }

            fn quotient(a: [$float; 2], b: [$float; 2], divisor: $float) -> $float {
                let sum = Self::dot(a, b);
                if divisor > 0.0 { sum / divisor } else { 0.0 }
            }

            // Two squares, their sum and the root: half a unit each, and the root halves the first.
            fn is_length(v: [$float; 2], length: $float) -> bool {
                let (low, high) = ($float::EPSILON.powi(2), 1.0 / $float::EPSILON.powi(2));
                if !v.iter().all(|s| (low..high).contains(&s.abs())) {
                    return true;
                }
                let exact = (v[0] as f64).hypot(v[1] as f64);
                (length as f64 - exact).abs() <= exact * $float::EPSILON as f64 * 1.01
            }

            fn is_ratio(ratio: Ratio, value: Option<$float>) -> bool {
                value.is_some_and(|value| {
                    is_nearest(value as f64, $float::MANTISSA_DIGITS as i32, ratio)
                })
            }

            fn represented(factor: impl Factor<$float>) -> Dyadic {
                dyadic(Factor::to_f64(factor))
            }
        }
    };
}

judge!(f32, product_f32);
judge!(f64, product_f64);

/// Equal values have equal bits: one NaN, one zero.
pub fn canonical<S: Scalar>(nans: &[S], zeros: &[S]) {
    for same in [nans, zeros] {
        assert!(same.iter().all(|s| s.bits() == same[0].bits()));
    }
    assert_ne!(nans[0].bits(), zeros[0].bits());
}
