//! What fixed point needs from its storage integer: a wide result, rounded once, clamped. `kernels` implements it.

#[cfg_attr(
    not(all(target_arch = "arm", not(target_has_atomic = "32"))),
    allow(dead_code)
)]
mod bitwise;
#[cfg_attr(
    all(target_arch = "arm", not(target_has_atomic = "32")),
    allow(dead_code)
)]
mod division;
mod high_product;
mod kernels;

use core::fmt::Debug;

pub(crate) use division::{Word, divide_words};

pub(super) use high_product::{
    ODD_SHIFT, high_product_i32, product_i32, rounded_product_i32, rounded_sum_i32,
};

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

    /// The same: cheaper where the quotient has few digits, as velocities and impulses have.
    fn short_quotient(wide: Self::Wide, divisor: Self) -> Self;

    /// The integer nearest to the square root of `x² + y²`, clamped.
    fn length(v: [Self; 2]) -> Self;

    /// `(m, up)` with `1 / sqrt(x² + y² + s²) = m / 2^(2 BITS - 2 - up)`, m of `BITS - 1` bits and
    /// off by less than a unit; `(0, 0)` where all are zero.
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
