//! A ratio as a mantissa and an exponent: how number types round it, once.

use core::num::NonZero;

use super::Ratio;

impl Ratio {
    /// `|self| = q * 2^e` with `q` rounded to `bits` bits (1 to 63), ties away from zero.
    /// `(0, 0)` for zero.
    #[inline(always)]
    pub(crate) fn mantissa(self, bits: u32) -> (u64, i32) {
        if self.num == 0 {
            return (0, 0);
        }
        let exponent = self.exponent() - bits as i32 + 1;
        let q = self.rounded(-exponent);
        if q >> bits == 0 {
            (q, exponent)
        } else {
            (q >> 1, exponent + 1)
        }
    }

    /// The same with `q` rounded down.
    #[inline(always)]
    pub(crate) fn floor_mantissa(self, bits: u32) -> (u64, i32) {
        if self.num == 0 {
            return (0, 0);
        }
        let exponent = self.exponent() - bits as i32 + 1;
        (self.floored(-exponent) as u64, exponent)
    }

    /// `|self| * 2^shift`, rounded to the nearest integer, ties away; `None` from `2^63`.
    #[inline(always)]
    pub(crate) fn shifted(self, shift: u32) -> Option<u64> {
        if self.num == 0 {
            return Some(0);
        }
        match self.exponent() + shift as i32 {
            0..=62 => Some(self.rounded(shift as i32)),
            ..-1 => Some(0),
            -1 => Some(1),
            _ => None,
        }
    }

    /// The e with `2^e <= |self| < 2^(e+1)`; `self` is not zero.
    #[inline(always)]
    fn exponent(self) -> i32 {
        let (num, den) = (self.num.unsigned_abs(), self.den);
        let (up, down) = (num.leading_zeros(), den.leading_zeros());
        let below = (num << up) < (den << down);
        down as i32 - up as i32 - below as i32
    }

    /// The least e with `|self| < 2^e`; zero for zero.
    pub(crate) fn exponent_above(self) -> i32 {
        match self.num {
            0 => 0,
            _ => self.exponent() + 1,
        }
    }

    /// `|self| * 2^shift` to the nearest integer, ties away; the result must be below `2^63`.
    #[inline(always)]
    fn rounded(self, shift: i32) -> u64 {
        ((self.floored(shift + 1) + 1) >> 1) as u64
    }

    /// The whole part of `|self| * 2^shift`, which must be below `2^64`.
    #[inline(always)]
    fn floored(self, shift: i32) -> u128 {
        let num = (self.num.unsigned_abs() as u128) << (shift.max(0) as u32 & 127);
        let den = (self.den as u128) << ((-shift).max(0) as u32 & 127);
        // Most ratios of a run are short, and a division of 128 bits costs thousands of instructions.
        match (u64::try_from(num), u64::try_from(den).map(NonZero::new)) {
            (Ok(num), Ok(Some(den))) => (num / den) as u128,
            _ => NonZero::new(den).map_or(0, |den| num / den),
        }
    }
}
