//! Angles beside floats: counted as beside fixed point, so that they wrap exactly and lose nothing
//! however far a body has rotated.

use super::circle::{circle_u32, circle_u64};
use super::{Angular, CarryAngular};
use crate::scalar::{Carry, Scalar};

/// A number of turns as a count of parts of one, modulo whole turns: nearest, odd; NaN is none.
macro_rules! count {
    ($name:ident, $float:ident, $mantissa:literal, $whole:ident, $signed:ident, $unsigned:ident) => {
        #[inline]
        fn $name(turns: $float) -> $unsigned {
            const ONE: $float = (1_u128 << ($unsigned::BITS - 1)) as $float * 2.0;
            const FINEST: $float = (1_u64 << ($mantissa - 2)) as $float;
            let mut part = turns;
            if !(turns > -0.5 && turns < 0.5) {
                // From twice that on a float has no fraction; infinity and NaN have none either.
                if !(turns > -2.0 * FINEST && turns < 2.0 * FINEST) {
                    return 0;
                }
                part -= turns as $whole as $float;
                if part >= 0.5 {
                    part -= 1.0;
                } else if part < -0.5 {
                    part += 1.0;
                }
            }
            let mut steps = part * ONE;
            if steps > -FINEST && steps < FINEST {
                steps += if steps < 0.0 { -0.5 } else { 0.5 };
            }
            steps as $signed as $unsigned
        }
    };
}

count!(count_f32, f32, 24, i32, i32, u32);
count!(count_fine_f32, f32, 24, i32, i64, u64);
count!(count_f64, f64, 53, i64, i64, u64);
count!(count_fine_f64, f64, 53, i64, i128, u128);

macro_rules! float_angular {
    ($float:ident, $turns:ident, $signed:ident, $count:path, $circle:path, $one:expr) => {
        impl Angular for $float {
            type Turns = $turns;
            type Unit = $float;

            const TAU: $float = core::$float::consts::TAU;
            const INFINITE_MASS: $float = 0.0;

            #[inline]
            fn advanced(angle: $turns, spin: $float, h: $float, halvings: u32) -> $turns {
                let h = if halvings == 0 { h } else { 0.5 * h };
                angle.wrapping_add($count(h * spin))
            }

            #[inline(always)]
            fn advanced_dyadic(angle: $turns, spin: $float, num: u32, shift: u32) -> $turns {
                angle.wrapping_add($count(spin.dyadic(num, shift)))
            }

            #[inline]
            fn part_of(angle: $turns, part: $float) -> $turns {
                (angle as $signed as $float * part) as $signed as $turns
            }

            #[inline]
            fn circle(angle: $turns) -> [$float; 2] {
                const UNIT: $float = 1.0 / $one as $float;
                $circle(angle).map(|value| value as $float * UNIT)
            }

            #[inline]
            fn rotated([cos, sin]: [$float; 2], [x, y]: [$float; 2]) -> [$float; 2] {
                [cos * x - sin * y, sin * x + cos * y]
            }

            #[inline]
            fn opposite(unit: $float) -> $float {
                -unit
            }

            #[inline]
            fn from_unit(unit: $float) -> $float {
                unit
            }

            #[inline]
            fn weighed(sum: $float, factor: $float) -> $float {
                sum * factor
            }
        }
    };
}

float_angular!(f32, u32, i32, count_f32, circle_u32, 1_u32 << 30);
float_angular!(f64, u64, i64, count_f64, circle_u64, 1_u64 << 62);

/// The remainder of a spin is what it has too much.
macro_rules! float_carry_angular {
    ($float:ident, $bits:ident, $remainder:ident, $turns:ident, $fine:ident, $count:path) => {
        impl CarryAngular for $float {
            type Fine = $fine;

            #[inline]
            fn fine(angle: $turns) -> $fine {
                (angle as $fine) << $turns::BITS
            }

            #[inline]
            fn coarse(fine: $fine) -> $turns {
                let (high, low) = ((fine >> $turns::BITS) as $turns, fine as $turns);
                let up = low >= (1 << ($turns::BITS - 1)) + (high >> ($turns::BITS - 1));
                high.wrapping_add(up as $turns)
            }

            #[inline]
            fn fine_rotated(
                fine: $fine,
                (spin, remainder): ($float, $remainder),
                h: $float,
                halvings: u32,
            ) -> $fine {
                let h = if halvings == 0 { h } else { 0.5 * h };
                fine.wrapping_add($count(h * spin)).wrapping_sub($count(
                    h * $float::from_bits((remainder as $bits) << ($bits::BITS / 2)),
                ))
            }

            #[inline(always)]
            fn fine_rotated_dyadic(
                fine: $fine,
                kept: ($float, $remainder),
                num: u32,
                shift: u32,
            ) -> $fine {
                let one: $float = 1.0;
                Self::fine_rotated(fine, kept, one.dyadic(num, shift), 0)
            }

            #[inline]
            fn twisted(
                kept: ($float, $remainder),
                sum: $float,
                factor: $float,
            ) -> ($float, $remainder) {
                <$float as Carry>::kicked(kept, sum, factor)
            }

            fn kept_to_f64((spin, remainder): ($float, $remainder)) -> f64 {
                spin as f64 - $float::from_bits((remainder as $bits) << ($bits::BITS / 2)) as f64
            }

            fn fine_halves(fine: $fine) -> [u64; 2] {
                [fine >> $turns::BITS, fine & $turns::MAX as $fine].map(|half| half as u64)
            }

            fn from_fine_halves(halves: [u64; 2]) -> Option<$fine> {
                let [high, low] = halves.map(|half| $turns::try_from(half).ok());
                Some((high? as $fine) << $turns::BITS | low? as $fine)
            }
        }
    };
}

float_carry_angular!(f32, u32, u16, u32, u64, count_fine_f32);
float_carry_angular!(f64, u64, u32, u64, u128, count_fine_f64);
