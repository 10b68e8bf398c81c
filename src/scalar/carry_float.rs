//! Remainders of floats: what a sum has too much, to be taken from the next (Kahan).
//!
//! Source: Kahan, "Further remarks on reducing truncation errors", Comm. ACM 8 (1965).

use super::Scalar;
use super::carry::Carry;

/// The upper half of the bits of an excess, rounded: it is small beside its sum, and the digits that
/// are left are enough.
macro_rules! short {
    ($bits:ident, $rest:ident, $excess:expr) => {{
        const HALF: u32 = $bits::BITS / 2;
        ($excess.to_bits().wrapping_add(1 << (HALF - 1)) >> HALF) as $rest
    }};
}

macro_rules! long {
    ($float:ident, $bits:ident, $rest:expr) => {
        $float::from_bits(($rest as $bits) << ($bits::BITS / 2))
    };
}

macro_rules! float_carry {
    ($float:ident, $bits:ident, $rest:ident) => {
        impl Carry for $float {
            /// The sum, and what it has too much.
            type Place = [$float; 2];
            type Rest = $rest;

            const NO_REST: $rest = 0;
            const REST_BYTES: usize = size_of::<$rest>();

            #[inline]
            fn place(self) -> [$float; 2] {
                [self, 0.0]
            }

            #[inline]
            fn seen([sum, _]: [$float; 2]) -> $float {
                sum
            }

            #[inline]
            fn beyond([sum, excess]: [$float; 2], from: $float) -> ($float, $rest) {
                (sum - from, short!($bits, $rest, excess))
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
                place: [$float; 2],
                value: $float,
                num: u32,
                shift: u32,
            ) -> [$float; 2] {
                Self::moved(place, value.dyadic(num, shift), 1.0, 0)
            }

            #[inline]
            fn drifted(
                [sum, excess]: [$float; 2],
                (v, rest): ($float, $rest),
                h: $float,
                halvings: u32,
            ) -> [$float; 2] {
                let h = if halvings == 0 { h } else { 0.5 * h };
                let excess = excess + h * long!($float, $bits, rest);
                Self::moved([sum, excess], v, h, 0)
            }

            #[inline(always)]
            fn drifted_dyadic(
                place: [$float; 2],
                kept: ($float, $rest),
                num: u32,
                shift: u32,
            ) -> [$float; 2] {
                let one: $float = 1.0;
                Self::drifted(place, kept, one.dyadic(num, shift), 0)
            }

            #[inline]
            fn kicked(
                (v, rest): ($float, $rest),
                value: $float,
                factor: $float,
            ) -> ($float, $rest) {
                let [v, excess] = Self::moved([v, long!($float, $bits, rest)], value, factor, 0);
                (v, short!($bits, $rest, excess))
            }

            #[inline]
            fn kicked_as(
                (v, rest): ($float, $rest),
                (value, more): ($float, $rest),
                factor: $float,
            ) -> ($float, $rest) {
                let excess = long!($float, $bits, rest) + factor * long!($float, $bits, more);
                let [v, excess] = Self::moved([v, excess], value, factor, 0);
                (v, short!($bits, $rest, excess))
            }

            #[inline]
            fn turned((v, rest): ($float, $rest)) -> ($float, $rest) {
                (-v, short!($bits, $rest, -long!($float, $bits, rest)))
            }

            #[inline]
            fn damped((v, rest): ($float, $rest), loss: $float) -> ($float, $rest) {
                let excess = long!($float, $bits, rest);
                let [v, excess] = Self::moved([v, excess - loss * excess], -v, loss, 0);
                (v, short!($bits, $rest, excess))
            }

            #[inline]
            fn pushed(
                [x, y]: [($float, $rest); 2],
                impulse: [$float; 2],
                inv_mass: $float,
            ) -> [($float, $rest); 2] {
                [
                    Self::kicked(x, impulse[0], inv_mass),
                    Self::kicked(y, impulse[1], inv_mass),
                ]
            }

            fn momentum((v, rest): ($float, $rest), inv_mass: $float) -> f64 {
                (v as f64 - long!($float, $bits, rest) as f64) / inv_mass as f64
            }

            fn left_over([_, excess]: [$float; 2]) -> u64 {
                excess.bits()
            }

            fn rest_left_over(rest: $rest) -> u64 {
                long!($float, $bits, rest).bits()
            }

            fn halves(place: [$float; 2]) -> [u64; 2] {
                place.map(|half| half.to_bits().into())
            }

            fn of_halves(halves: [u64; 2]) -> Option<[$float; 2]> {
                let [sum, excess] = halves.map(|half| $bits::try_from(half).ok());
                Some([$float::from_bits(sum?), $float::from_bits(excess?)])
            }

            fn rest_bits(rest: $rest) -> u64 {
                rest.into()
            }

            fn of_rest_bits(bits: u64) -> Option<$rest> {
                $rest::try_from(bits).ok()
            }
        }
    };
}

float_carry!(f32, u32, u16);
float_carry!(f64, u64, u32);
