//! Rounding remainders for *carried* bodies, which keep what rounding loses.
//!
//! `fixed.rs` and `float.rs` say what a number type keeps.

mod drift;
pub(super) mod fine;
mod fixed;
mod float;

use super::Scalar;

/// A number type for *carried* bodies, which keep what rounding loses.
///
/// ```
/// use fixstep::{Carry, fixed::types::I16F16};
/// let slow = I16F16::DELTA; // one unit a second
/// let mut x = I16F16::ZERO.fine_position();
/// for _ in 0..64 {
///     x = I16F16::moved_dyadic(x, slow, 1, 6); // 1/64 s
/// }
/// assert_eq!(I16F16::seen(x), slow);
/// ```
pub trait Carry: Scalar {
    /// A fine position: a position with its rounding remainder.
    type FinePosition: Copy + core::fmt::Debug + PartialEq + 'static;

    /// The rounding remainder of a velocity.
    type Remainder: Copy + core::fmt::Debug + PartialEq + 'static;

    /// The remainder zero.
    const NO_REMAINDER: Self::Remainder;

    /// Bytes of a remainder in a snapshot.
    const REMAINDER_BYTES: usize;

    /// The fine position whose remainder is zero.
    #[must_use]
    fn fine_position(self) -> Self::FinePosition;

    /// The position nearest to a fine position.
    #[must_use]
    fn seen(position: Self::FinePosition) -> Self;

    /// `position - from`, with as much of the remainder of the position as one of a velocity holds; a float rounds
    /// the difference.
    #[must_use]
    fn beyond(position: Self::FinePosition, from: Self) -> (Self, Self::Remainder);

    /// `2 about - position`, saturating.
    #[must_use]
    fn mirrored(position: Self::FinePosition, about: Self) -> Self::FinePosition;

    /// `position + factor * value / 2^halvings`, saturating; `halvings` is 0 or 1.
    #[must_use]
    fn moved(
        position: Self::FinePosition,
        value: Self,
        factor: Self::Coef,
        halvings: u32,
    ) -> Self::FinePosition;

    /// `position + num / 2^shift * value`, exact in fixed point; called with constants.
    #[must_use]
    fn moved_dyadic(
        position: Self::FinePosition,
        value: Self,
        num: u32,
        shift: u32,
    ) -> Self::FinePosition;

    /// `position + h * v / 2^halvings` for a velocity with its remainder.
    #[must_use]
    fn drifted(
        position: Self::FinePosition,
        kept: (Self, Self::Remainder),
        h: Self::Coef,
        halvings: u32,
    ) -> Self::FinePosition;

    /// `position + num / 2^shift * v`, in the same way; called with constants.
    #[must_use]
    fn drifted_dyadic(
        position: Self::FinePosition,
        kept: (Self, Self::Remainder),
        num: u32,
        shift: u32,
    ) -> Self::FinePosition;

    /// A velocity and its remainder after `+ factor * value`.
    #[must_use]
    fn kicked(
        kept: (Self, Self::Remainder),
        value: Self,
        factor: Self::Coef,
    ) -> (Self, Self::Remainder);

    /// The same after `+ factor * value` for a value with its remainder.
    #[must_use]
    fn kicked_as(
        kept: (Self, Self::Remainder),
        value: (Self, Self::Remainder),
        factor: Self::Coef,
    ) -> (Self, Self::Remainder);

    /// The same after `v = -v`.
    #[must_use]
    fn reversed(kept: (Self, Self::Remainder)) -> (Self, Self::Remainder);

    /// The same after losing `loss` of both, for a loss from 0 to 1: towards zero and never past it.
    /// In fixed point at least one unit of the remainder is lost, so that the velocity reaches zero.
    #[must_use]
    fn damped(kept: (Self, Self::Remainder), loss: Self::Coef) -> (Self, Self::Remainder);

    /// Both parts of a velocity after `+ impulse / m`. In fixed point their momentum changes by exactly
    /// the impulse: up to `2^15` kg, and while the velocity stays within its range.
    #[must_use]
    fn pushed(
        kept: [(Self, Self::Remainder); 2],
        impulse: [Self; 2],
        inv_mass: Self::InvMass,
    ) -> [(Self, Self::Remainder); 2];

    /// The momentum of a velocity with its remainder; exact in fixed point.
    #[must_use]
    fn momentum(kept: (Self, Self::Remainder), inv_mass: Self::InvMass) -> f64;

    /// What a position holds beyond the position that is seen, for a hash: equal for equal fine positions.
    #[must_use]
    fn left_over(position: Self::FinePosition) -> u64;

    /// What a remainder holds, for a hash: equal for equal remainders, one NaN.
    #[must_use]
    fn remainder_left_over(remainder: Self::Remainder) -> u64;

    /// The bits of a position in two halves of a scalar's size.
    #[must_use]
    fn halves(position: Self::FinePosition) -> [u64; 2];

    /// The position of those halves; `None` where they have more bits than a scalar.
    #[must_use]
    fn from_halves(halves: [u64; 2]) -> Option<Self::FinePosition>;

    /// The exact bits of a remainder, in its [`REMAINDER_BYTES`](Carry::REMAINDER_BYTES) lowest bytes.
    #[must_use]
    fn remainder_bits(remainder: Self::Remainder) -> u64;

    /// The remainder of those bits; `None` where no remainder has them.
    #[must_use]
    fn from_remainder_bits(bits: u64) -> Option<Self::Remainder>;
}
