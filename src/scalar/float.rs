//! `f32` and `f64`: plain IEEE arithmetic, no fused multiply-add, so that bits agree everywhere.
//!
//! Rounding is nearest, ties to even: odd, as the laws require. Overflow gives an
//! infinity, which stays; `is_inside` tests for it.

use super::{Factor, Scalar};
use crate::ratio::Ratio;

macro_rules! float_scalar {
    ($float:ident, $bits:ident, $mantissa:literal, $sqrt:path) => {
        impl Factor<$float> for $float {
            #[inline(always)]
            fn new(ratio: Ratio) -> Option<$float> {
                <$float>::ratio(ratio)
            }

            #[inline]
            fn scale(self, value: $float) -> $float {
                self * value
            }

            #[inline]
            fn to_f64(self) -> f64 {
                self as f64
            }
        }

        impl Scalar for $float {
            type Coef = $float;
            type Span = $float;
            type InvMass = $float;
            type Sum = $float;
            type Gain = $float;

            const ZERO: $float = 0.0;
            const MAX: $float = $float::MAX;
            const COEF_BITS: u32 = 62;

            // Always normal: a ratio lies between 2^-62 and 2^62.
            #[inline(always)]
            fn ratio(ratio: Ratio) -> Option<$float> {
                const FRACTION: u32 = $mantissa - 1;
                let (mantissa, exponent) = ratio.mantissa($mantissa);
                if mantissa == 0 {
                    return Some(0.0);
                }
                let bias = <$float>::MAX_EXP - 1;
                let exponent = (exponent + FRACTION as i32 + bias) as $bits;
                let bits = (exponent << FRACTION) | (mantissa as $bits & ((1 << FRACTION) - 1));
                let magnitude = <$float>::from_bits(bits);
                Some(if ratio.num() < 0 {
                    -magnitude
                } else {
                    magnitude
                })
            }

            #[inline]
            fn plus(self, other: $float) -> $float {
                self + other
            }

            #[inline]
            fn minus(self, other: $float) -> $float {
                self - other
            }

            #[inline]
            fn negated(self) -> $float {
                -self
            }

            #[inline]
            fn times(self, other: $float) -> $float {
                self * other
            }

            #[inline(always)]
            fn dyadic(self, num: u32, shift: u32) -> $float {
                self * (num as $float / (1_u32 << (shift & 31)) as $float)
            }

            #[inline]
            fn gain(self, h: $float) -> $float {
                h * self
            }

            #[inline]
            fn gained(gain: $float, _tick: u64) -> $float {
                gain
            }

            #[inline]
            fn dot(a: [$float; 2], b: [$float; 2]) -> $float {
                a[0] * b[0] + a[1] * b[1]
            }

            #[inline]
            fn narrow(sum: $float) -> $float {
                sum
            }

            #[inline]
            fn quotient(sum: $float, divisor: Self) -> $float {
                if divisor > 0.0 { sum / divisor } else { 0.0 }
            }

            #[inline]
            fn length(v: [$float; 2]) -> $float {
                $sqrt(v[0] * v[0] + v[1] * v[1])
            }

            #[inline]
            fn inverse_length(v: [$float; 2], softening: $float) -> $float {
                let square = v[0] * v[0] + v[1] * v[1] + softening * softening;
                if square == 0.0 {
                    0.0
                } else {
                    1.0 / $sqrt(square)
                }
            }

            #[inline]
            fn coef(self) -> $float {
                self
            }

            #[inline]
            fn mass(inverse: $float) -> $float {
                1.0 / inverse
            }

            #[inline]
            fn product(a: $float, b: $float) -> $float {
                a * b
            }

            #[inline]
            fn is_inside(self) -> bool {
                self.is_finite()
            }

            // NaN payloads differ between targets, and -0 == 0.
            #[inline]
            fn bits(self) -> u64 {
                let canonical = if self.is_nan() {
                    <$float>::NAN
                } else {
                    self + 0.0
                };
                canonical.to_bits() as u64
            }

            #[inline]
            fn to_f64(self) -> f64 {
                self as f64
            }
        }
    };
}

float_scalar!(f32, u32, 24, libm::sqrtf);
float_scalar!(f64, u64, 53, libm::sqrt);
