//! The kernels of [`Raw`] for the integers that store fixed point.

use core::num::NonZero;

// ARM cores without a division are told as in `high_product.rs`.
use super::Raw;
#[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
use super::bitwise::{divide_short, root_u64};
use super::division::{divide_u64, divide_u128, root_u128};
#[cfg(not(all(target_arch = "arm", not(target_has_atomic = "32"))))]
use super::division::{divide_u64 as divide_short, root_u64};
use super::high_product::{high_product_i32, high_product_i64};

/// A quotient, rounded, by a division of what has no sign.
macro_rules! nearest {
    ($raw:ident, $unsigned:ident, $divide:path, $wide:ident, $divisor:ident) => {{
        let Some(divisor) = NonZero::new($divisor.max(0) as $unsigned) else {
            return 0;
        };
        let value = match $divide($wide.unsigned_abs(), divisor) {
            Some((whole, remainder)) => {
                let up = (remainder >= divisor.get() - remainder) as $unsigned;
                whole.saturating_add(up).min($raw::MAX as $unsigned) as $raw
            }
            None => $raw::MAX,
        };
        if $wide < 0 { -value } else { value }
    }};
}

macro_rules! raw {
    ($raw:ident, $unsigned:ident, $wide:ident, $unsigned_wide:ident, $high_product:path, $root:path,
     $divide:path, $short:path) => {
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

            // Less one, the sum of two squares of the lowest value fits, and the two highest bits of what
            // lies within the limits are equal.
            #[inline]
            fn dot(a: [$raw; 2], b: [$raw; 2]) -> $wide {
                const LIMIT: $wide = 1 << ($wide::BITS - 2);
                let less = (a[0].product(b[0]) - 1) + a[1].product(b[1]);
                match (less >> ($wide::BITS - 2)) as $raw {
                    0 | -1 => less + 1,
                    1.. => LIMIT,
                    _ => -LIMIT,
                }
            }

            // The shift floors. Half a unit more makes it nearest with ties up; one less below
            // zero sends those ties down. In halves: shifts of a wide number are slow on small
            // cores, and a shift beyond the lower half cannot leave the range.
            #[inline]
            fn rounded(wide: $wide, shift: u32) -> $raw {
                const MASK: u32 = $raw::BITS - 1;
                let half = 1 << (shift.wrapping_sub(1) & MASK);
                let below = wide >> ($wide::BITS - 1);
                if shift > $raw::BITS {
                    let high = (wide.wrapping_add(below) >> $raw::BITS) as $raw;
                    return high.wrapping_add(half) >> (shift & MASK);
                }
                let sum = wide
                    .wrapping_add(below)
                    .wrapping_add(half as $unsigned as $wide);
                let (high, low) = ((sum >> $raw::BITS) as $raw, sum as $unsigned);
                let last = shift.wrapping_sub(1) & MASK;
                if high >> last != high >> MASK {
                    return high.limit();
                }
                let value = high << (MASK - last) | (low >> 1 >> last) as $raw;
                value.max(-$raw::MAX)
            }

            #[inline]
            fn quotient(wide: $wide, divisor: $raw) -> $raw {
                nearest!($raw, $unsigned, $divide, wide, divisor)
            }

            #[inline]
            fn short_quotient(wide: $wide, divisor: $raw) -> $raw {
                nearest!($raw, $unsigned, $short, wide, divisor)
            }

            #[inline]
            fn length(v: [$raw; 2]) -> $raw {
                let [x, y] = v;
                let square = x.product(x) as $unsigned_wide + y.product(y) as $unsigned_wide;
                let (root, up) = $root(square);
                let root = root >> (up / 2);
                // At most twice a root that is not clamped.
                let remainder = (square as $unsigned).wrapping_sub(root.wrapping_mul(root));
                let up = (remainder > root) as $unsigned;
                root.saturating_add(up).min($raw::MAX as $unsigned) as $raw
            }

            // The sum of three squares has room in the unsigned type. Shifted up by an even number
            // of bits, its root has as many bits as `$unsigned`, its inverse one less.
            #[inline]
            fn inverse_length(v: [$raw; 2], s: $raw) -> ($raw, u32) {
                let [x, y] = v;
                let square = (x.product(x) as $unsigned_wide)
                    .wrapping_add(y.product(y) as $unsigned_wide)
                    .wrapping_add(s.product(s) as $unsigned_wide);
                let (root, up) = $root(square);
                let Some(root) = NonZero::new(root) else {
                    return (0, 0);
                };
                let inverse = $divide($wide::MAX as $unsigned_wide >> 1, root);
                (inverse.map_or(0, |(whole, _)| whole as $raw), up / 2)
            }

            #[inline]
            fn reciprocal(self) -> $raw {
                const ONE: $unsigned_wide = 1 << ($wide::BITS - 4);
                let Some(divisor) = NonZero::new(self.unsigned_abs()) else {
                    return 0;
                };
                let half = (divisor.get() / 2) as $unsigned_wide;
                $divide(ONE + half, divisor).map_or($raw::MAX, |(whole, _)| whole as $raw)
            }

            // As in `rounded`. A small numerator needs no wide product: with v = high 2^H + low,
            // the floors of the two parts add up, and half a unit is a multiple of 2^H. For a shift
            // alone one is taken from what is not above zero and can lose it, so that ties go down
            // there; then the last bit but one rounds. Nothing leaves the range, so nothing branches.
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
                let less = self.wrapping_add(self.wrapping_sub(1) >> MASK);
                match shift {
                    1 => (less >> 1) + (less & 1),
                    _ => ((less >> (shift.wrapping_sub(1) & MASK)) + 1) >> 1,
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

            // The bits of the product, less those a mantissa has: shifted up so that these are the
            // upper half, the rounding looks at one bit. A product of two is at most a quarter of
            // the range.
            #[inline]
            fn renormalised(product: $wide) -> ($raw, u32) {
                const MASK: u32 = $raw::BITS - 1;
                let magnitude = product.unsigned_abs();
                if magnitude >> MASK == 0 {
                    return (product as $raw, 0);
                }
                let (high, low) = (
                    (magnitude >> $raw::BITS) as $unsigned,
                    magnitude as $unsigned,
                );
                let up = high.leading_zeros().wrapping_sub(1) & MASK;
                let next = low >> (MASK - up);
                let value = (high << up | next >> 1) + (next & 1);
                let value = value.min($raw::MAX as $unsigned) as $raw;
                (if product < 0 { -value } else { value }, $raw::BITS - up)
            }
        }
    };
}

raw!(
    i32,
    u32,
    i64,
    u64,
    high_product_i32,
    root_u64,
    divide_u64,
    divide_short
);
raw!(
    i64,
    u64,
    i128,
    u128,
    high_product_i64,
    root_u128,
    divide_u128,
    divide_u128
);
