//! Integer kernels under the fixed-point types: a wide result, rounded once, clamped.

use core::fmt::Debug;
use core::num::NonZero;

use super::high_product::{high_product_i32, high_product_i64};

/// A storage integer with a type twice as wide.
pub trait Raw: Copy + Debug + PartialEq + 'static {
    /// Holds any product of two.
    type Wide: Copy + Debug;

    /// Bits of storage.
    const BITS: u32;

    /// `±magnitude`, for magnitudes that fit.
    fn signed(magnitude: u64, negative: bool) -> Self;

    /// The largest magnitude with the sign of `self`.
    fn limit(self) -> Self;

    /// `self` with its lowest five bits cleared, and those bits.
    fn unpacked(self) -> (Self, u32);

    /// The nearest `f64`.
    fn to_f64(self) -> f64;

    /// The full product.
    fn product(self, other: Self) -> Self::Wide;

    /// `floor(self * other / 2^BITS)`.
    fn high_product(self, other: Self) -> Self;

    /// `a0 b0 + a1 b1`, clamped to `±2^(2 BITS - 2)`: whatever is larger saturates when narrowed.
    fn dot(a: [Self; 2], b: [Self; 2]) -> Self::Wide;

    /// `wide / 2^shift`, nearest, ties away from zero, clamped to `±MAX` so that it can be
    /// negated; `1 <= shift <= 2 BITS - 2` and `|wide| <= 2^(2 BITS - 2)`.
    fn rounded(wide: Self::Wide, shift: u32) -> Self;

    /// `wide / divisor`, rounded and clamped as above; zero for a divisor that is not positive.
    fn quotient(wide: Self::Wide, divisor: Self) -> Self;

    /// The integer nearest to the square root of `x² + y²`, clamped.
    fn length(v: [Self; 2]) -> Self;

    /// `(m, up)` with `1 / sqrt(x² + y² + s²) = m / 2^(2 BITS - 2 - up)`, m of `BITS - 1` bits and
    /// off by less than two units; `(0, 0)` where all are zero.
    fn inverse_length(v: [Self; 2], s: Self) -> (Self, u32);

    /// `2^(2 BITS - 4) / self`, nearest, for a self of `BITS - 1` bits; zero for zero.
    fn reciprocal(self) -> Self;

    /// `num / 2^shift * self`, nearest, ties away, clamped; `num <= 2^30`, `1 <= shift <= 30`.
    fn dyadic(self, num: u32, shift: u32) -> Self;

    /// `self / 2^shift`, nearest with ties up; `1 <= shift < BITS`, `|self| < 2^(BITS-2)`.
    fn half_up(self, shift: u32) -> Self;

    /// `wide / 2^shift` as a whole part towards zero, a unit of its sign, and 32 bits of fraction;
    /// `1 <= shift <= 2 BITS - 2`. The whole part leaves room for the unit.
    fn split(wide: Self::Wide, shift: u32) -> (Self, Self, u32);

    /// A product of two mantissas as a mantissa: the value, and the shift that led there.
    fn renormalised(product: Self::Wide) -> (Self, u32);
}

macro_rules! raw {
    ($raw:ident, $unsigned:ident, $wide:ident, $unsigned_wide:ident, $high_product:path) => {
        impl Raw for $raw {
            type Wide = $wide;

            const BITS: u32 = $raw::BITS;

            #[inline]
            fn signed(magnitude: u64, negative: bool) -> $raw {
                let value = magnitude as $raw;
                if negative {
                    value.wrapping_neg()
                } else {
                    value
                }
            }

            #[inline]
            fn limit(self) -> $raw {
                if self < 0 { -$raw::MAX } else { $raw::MAX }
            }

            #[inline]
            fn unpacked(self) -> ($raw, u32) {
                (self & !31, self as u32 & 31)
            }

            #[inline]
            fn to_f64(self) -> f64 {
                self as f64
            }

            #[inline]
            fn product(self, other: $raw) -> $wide {
                self as $wide * other as $wide
            }

            #[inline]
            fn high_product(self, other: $raw) -> $raw {
                $high_product(self, other)
            }

            #[inline]
            fn dot(a: [$raw; 2], b: [$raw; 2]) -> $wide {
                const LIMIT: $wide = 1 << ($wide::BITS - 2);
                let sum = a[0].product(b[0]).saturating_add(a[1].product(b[1]));
                sum.clamp(-LIMIT, LIMIT)
            }

            // The shift floors. Half a unit more makes it nearest with ties up; one less below
            // zero sends those ties down.
            #[inline]
            fn rounded(wide: $wide, shift: u32) -> $raw {
                const MASK: u32 = $wide::BITS - 1;
                const LIMIT: $wide = $raw::MAX as $wide;
                let half = 1 << (shift.wrapping_sub(1) & MASK);
                let below = wide >> MASK;
                let value = wide.wrapping_add(half).wrapping_add(below) >> (shift & MASK);
                value.clamp(-LIMIT, LIMIT) as $raw
            }

            #[inline]
            fn quotient(wide: $wide, divisor: $raw) -> $raw {
                let Some(divisor) = NonZero::new(divisor.max(0) as $unsigned_wide) else {
                    return 0;
                };
                let magnitude = wide.unsigned_abs();
                let (whole, rest) = (magnitude / divisor, magnitude % divisor);
                let up = (rest >= divisor.get() - rest) as $unsigned_wide;
                let value = (whole + up).min($raw::MAX as $unsigned_wide) as $raw;
                if wide < 0 { -value } else { value }
            }

            #[inline]
            fn length(v: [$raw; 2]) -> $raw {
                let square = Self::dot(v, v) as $unsigned_wide;
                let root = square.isqrt();
                let up = (square - root * root > root) as $unsigned_wide;
                (root + up).min($raw::MAX as $unsigned_wide) as $raw
            }

            // The sum of three squares has room in the unsigned type. Shifted up by an even number
            // of bits, its root has as many bits as `$unsigned`, its inverse one less.
            #[inline]
            fn inverse_length(v: [$raw; 2], s: $raw) -> ($raw, u32) {
                let [x, y, s] = [v[0], v[1], s].map(|a| a.product(a) as $unsigned_wide);
                let square = x.wrapping_add(y).wrapping_add(s);
                let up = square.leading_zeros() & !1;
                let root = (square << (up & ($wide::BITS - 1))).isqrt();
                match NonZero::new(root) {
                    None => (0, 0),
                    Some(root) => ((($wide::MAX as $unsigned_wide >> 1) / root) as $raw, up / 2),
                }
            }

            #[inline]
            fn reciprocal(self) -> $raw {
                let Some(divisor) = NonZero::new(self.unsigned_abs() as $unsigned_wide) else {
                    return 0;
                };
                let one: $unsigned_wide = 1 << ($wide::BITS - 4);
                ((one + divisor.get() / 2) / divisor) as $raw
            }

            // As in `rounded`. A small numerator needs no wide product: with v = high 2^H + low,
            // the floors of the two parts add up, and half a unit is a multiple of 2^H. A shift
            // alone leaves the range only within half a unit of the top, where the result is the
            // next whole number up.
            #[inline(always)]
            fn dyadic(self, num: u32, shift: u32) -> $raw {
                const MASK: u32 = $raw::BITS - 1;
                const H: u32 = $raw::BITS / 2;
                if num != 1 && num >> 15 == 0 && shift > H {
                    let (high, low) = (self >> H, self & ((1 << H) - 1));
                    let carry = (low.wrapping_mul(num as $raw) + (self >> MASK)) >> H;
                    let half = 1 << (shift - 1 - H);
                    return (high.wrapping_mul(num as $raw) + half + carry) >> (shift - H);
                }
                if num != 1 {
                    return Self::rounded((self as $wide).wrapping_mul(num as $wide), shift);
                }
                let half = 1 << (shift.wrapping_sub(1) & MASK);
                match self.checked_add(half) {
                    Some(sum) => sum.wrapping_add(self >> MASK) >> (shift & MASK),
                    None => (self >> (shift & MASK)) + 1,
                }
            }

            #[inline]
            fn half_up(self, shift: u32) -> $raw {
                const MASK: u32 = $raw::BITS - 1;
                let half = 1 << (shift.wrapping_sub(1) & MASK);
                self.wrapping_add(half) >> (shift & MASK)
            }

            #[inline]
            fn split(wide: $wide, shift: u32) -> ($raw, $raw, u32) {
                const MASK: u32 = $wide::BITS - 1;
                let magnitude = wide.unsigned_abs();
                let fraction = match shift {
                    32.. => magnitude >> (shift - 32 & MASK),
                    _ => magnitude << (32 - shift & MASK),
                };
                const LIMIT: $unsigned_wide = $raw::MAX as $unsigned_wide - 1;
                let whole = (magnitude >> (shift & MASK)).min(LIMIT) as $raw;
                let (whole, unit) = if wide < 0 { (-whole, -1) } else { (whole, 1) };
                (whole, unit, fraction as u32)
            }

            // The bits of the product, less those a mantissa has.
            #[inline]
            fn renormalised(product: $wide) -> ($raw, u32) {
                let bits = $wide::BITS - product.unsigned_abs().leading_zeros();
                let shift = bits.saturating_sub($raw::BITS - 1);
                match shift {
                    0 => (product as $raw, 0),
                    _ => (Self::rounded(product, shift), shift),
                }
            }
        }
    };
}

raw!(i32, u32, i64, u64, high_product_i32);
raw!(i64, u64, i128, u128, high_product_i64);
