//! Remainders of floats: what a sum has too much, to be taken from the next (Kahan).
//!
//! Source: Kahan, "Further remarks on reducing truncation errors", Comm. ACM 8 (1965).

use super::Scalar;
use super::carry::Carry;

macro_rules! float_carry {
    ($float:ident, $bits:ident, $rest:ident, $lost:expr, $short:expr) => {
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
            fn kicked(
                (v, rest): ($float, $rest),
                value: $float,
                factor: $float,
            ) -> ($float, $rest) {
                let [v, excess] = Self::moved([v, $lost(rest)], value, factor, 0);
                (v, $short(excess))
            }

            #[inline]
            fn damped((v, rest): ($float, $rest), loss: $float) -> ($float, $rest) {
                let excess = $lost(rest);
                let [v, excess] = Self::moved([v, excess - loss * excess], -v, loss, 0);
                (v, $short(excess))
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
                (v as f64 - $lost(rest) as f64) / inv_mass as f64
            }

            fn left_over([_, excess]: [$float; 2]) -> u64 {
                excess.bits()
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

// The upper half of its bits, rounded: what a sum has too much is small beside it, and eight digits
// of that are enough.
float_carry!(
    f32,
    u32,
    u16,
    |rest: u16| f32::from_bits((rest as u32) << 16),
    |excess: f32| { (excess.to_bits().wrapping_add(0x8000) >> 16) as u16 }
);
float_carry!(
    f64,
    u64,
    u32,
    |rest: u32| f64::from_bits((rest as u64) << 32),
    |excess: f64| { (excess.to_bits().wrapping_add(1 << 31) >> 32) as u32 }
);
