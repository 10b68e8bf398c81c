//! Remainders of floats: the excess of a sum, subtracted from the next one (Kahan).
//!
//! Source: Kahan, "Further remarks on reducing truncation errors", Comm. ACM 8 (1965).

use super::Carry;
use crate::scalar::Scalar;

/// The upper half of the bits of an excess, rounded. The excess is small compared with its sum, so
/// these digits are enough.
macro_rules! short {
    ($bits:ident, $remainder:ident, $excess:expr) => {{
        const HALF: u32 = $bits::BITS / 2;
        ($excess.to_bits().wrapping_add(1 << (HALF - 1)) >> HALF) as $remainder
    }};
}

macro_rules! long {
    ($float:ident, $bits:ident, $remainder:expr) => {
        $float::from_bits(($remainder as $bits) << ($bits::BITS / 2))
    };
}

macro_rules! float_carry {
    ($float:ident, $bits:ident, $remainder:ident) => {
        impl Carry for $float {
            /// The sum and its excess.
            type FinePosition = [$float; 2];
            type Remainder = $remainder;

            const NO_REMAINDER: $remainder = 0;
            const REMAINDER_BYTES: usize = size_of::<$remainder>();

            #[inline]
            fn fine_position(self) -> [$float; 2] {
                [self, 0.0]
            }

            #[inline]
            fn seen([sum, _]: [$float; 2]) -> $float {
                sum
            }

            #[inline]
            fn beyond([sum, excess]: [$float; 2], from: $float) -> ($float, $remainder) {
                (sum - from, short!($bits, $remainder, excess))
            }

            #[inline]
            fn mirrored([sum, excess]: [$float; 2], about: $float) -> [$float; 2] {
                Self::moved([-sum, -excess], about, 2.0, 0)
            }

            #[inline]
            fn moved(
                [sum, excess]: [$float; 2],
                value: $float,
                h: $float,
                halvings: u32,
            ) -> [$float; 2] {
                let h = if halvings == 0 { h } else { 0.5 * h };
                let term = h * value - excess;
                let next = sum + term;
                [next, (next - sum) - term]
            }

            #[inline(always)]
            fn moved_dyadic(
                position: [$float; 2],
                value: $float,
                num: u32,
                shift: u32,
            ) -> [$float; 2] {
                Self::moved(position, value.dyadic(num, shift), 1.0, 0)
            }

            #[inline]
            fn drifted(
                [sum, excess]: [$float; 2],
                (v, remainder): ($float, $remainder),
                h: $float,
                halvings: u32,
            ) -> [$float; 2] {
                let h = if halvings == 0 { h } else { 0.5 * h };
                let excess = excess + h * long!($float, $bits, remainder);
                Self::moved([sum, excess], v, h, 0)
            }

            #[inline(always)]
            fn drifted_dyadic(
                position: [$float; 2],
                kept: ($float, $remainder),
                num: u32,
                shift: u32,
            ) -> [$float; 2] {
                let one: $float = 1.0;
                Self::drifted(position, kept, one.dyadic(num, shift), 0)
            }

            #[inline]
            fn kicked(
                (v, remainder): ($float, $remainder),
                value: $float,
                factor: $float,
            ) -> ($float, $remainder) {
                let [v, excess] =
                    Self::moved([v, long!($float, $bits, remainder)], value, factor, 0);
                (v, short!($bits, $remainder, excess))
            }

            #[inline]
            fn kicked_as(
                (v, remainder): ($float, $remainder),
                (value, more): ($float, $remainder),
                factor: $float,
            ) -> ($float, $remainder) {
                let excess = long!($float, $bits, remainder) + factor * long!($float, $bits, more);
                let [v, excess] = Self::moved([v, excess], value, factor, 0);
                (v, short!($bits, $remainder, excess))
            }

            #[inline]
            fn reversed((v, remainder): ($float, $remainder)) -> ($float, $remainder) {
                (
                    -v,
                    short!($bits, $remainder, -long!($float, $bits, remainder)),
                )
            }

            #[inline]
            fn damped((v, remainder): ($float, $remainder), loss: $float) -> ($float, $remainder) {
                let excess = long!($float, $bits, remainder);
                let [v, excess] = Self::moved([v, excess - loss * excess], -v, loss, 0);
                (v, short!($bits, $remainder, excess))
            }

            #[inline]
            fn pushed(
                [x, y]: [($float, $remainder); 2],
                impulse: [$float; 2],
                inv_mass: $float,
            ) -> [($float, $remainder); 2] {
                [
                    Self::kicked(x, impulse[0], inv_mass),
                    Self::kicked(y, impulse[1], inv_mass),
                ]
            }

            fn momentum((v, remainder): ($float, $remainder), inv_mass: $float) -> f64 {
                (v as f64 - long!($float, $bits, remainder) as f64) / inv_mass as f64
            }

            fn left_over([_, excess]: [$float; 2]) -> u64 {
                excess.bits()
            }

            fn remainder_left_over(remainder: $remainder) -> u64 {
                long!($float, $bits, remainder).bits()
            }

            fn halves(position: [$float; 2]) -> [u64; 2] {
                position.map(|half| half.to_bits().into())
            }

            fn from_halves(halves: [u64; 2]) -> Option<[$float; 2]> {
                let [sum, excess] = halves.map(|half| $bits::try_from(half).ok());
                Some([$float::from_bits(sum?), $float::from_bits(excess?)])
            }

            fn remainder_bits(remainder: $remainder) -> u64 {
                remainder.into()
            }

            fn from_remainder_bits(bits: u64) -> Option<$remainder> {
                $remainder::try_from(bits).ok()
            }
        }
    };
}

float_carry!(f32, u32, u16);
float_carry!(f64, u64, u32);
