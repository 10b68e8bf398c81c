//! An angle as an integer fraction of a turn. It wraps exactly at a full turn.

use core::fmt::Debug;
use core::num::NonZero;

use crate::ratio::Ratio;

/// A fraction of a turn. It uses all bits of an integer, so that sums wrap exactly.
///
/// ```
/// use fixstep::{dec, scalar::Turns};
/// let angle = u32::nearest(dec!(0.75));
/// assert_eq!(angle.to_f64(), -0.25);
/// assert_eq!(angle.plus(angle), u32::nearest(dec!(0.5))); // 1.5 turns wrap to 0.5
/// ```
pub trait Turns: Copy + Debug + Eq + 'static {
    /// The zero angle.
    const ZERO: Self;

    /// The fraction of a turn nearest to `turns`; whole turns are dropped.
    #[must_use]
    fn nearest(turns: Ratio) -> Self;

    /// `self + other`.
    #[must_use]
    fn plus(self, other: Self) -> Self;

    /// `-self`.
    #[must_use]
    fn negated(self) -> Self;

    /// Turns from -1/2 to 1/2, for reports.
    #[must_use]
    fn to_f64(self) -> f64;

    /// The exact bits.
    #[must_use]
    fn bits(self) -> u64;

    /// The angle with these bits; `None` where they do not fit.
    #[must_use]
    fn from_bits(bits: u64) -> Option<Self>;
}

macro_rules! turns {
    ($unsigned:ident, $signed:ident) => {
        impl Turns for $unsigned {
            const ZERO: $unsigned = 0;

            // The remainder is below the denominator, of 62 bits at most. Odd, as rounding is.
            #[inline(always)]
            fn nearest(turns: Ratio) -> $unsigned {
                let Some(den) = NonZero::new(turns.den() as u128) else {
                    return 0;
                };
                let rest = turns.num().unsigned_abs() as u128 % den;
                let count = ((rest << $unsigned::BITS) + den.get() / 2) / den;
                let count = count as $unsigned;
                if turns.num() < 0 {
                    count.wrapping_neg()
                } else {
                    count
                }
            }

            #[inline]
            fn plus(self, other: $unsigned) -> $unsigned {
                self.wrapping_add(other)
            }

            #[inline]
            fn negated(self) -> $unsigned {
                self.wrapping_neg()
            }

            fn to_f64(self) -> f64 {
                self as $signed as f64 / (1_u128 << $unsigned::BITS) as f64
            }

            fn bits(self) -> u64 {
                self.into()
            }

            fn from_bits(bits: u64) -> Option<$unsigned> {
                $unsigned::try_from(bits).ok()
            }
        }
    };
}

turns!(u32, i32);
turns!(u64, i64);
