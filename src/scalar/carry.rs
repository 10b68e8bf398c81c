//! What roundings leave over, kept: for a body that loses nothing to them.
//!
//! `carry_fixed.rs` and `carry_float.rs` say what a number type keeps.

use super::Scalar;

/// A number type whose roundings can be kept.
pub trait Carry: Scalar {
    /// A position with what moves left over.
    type Place: Copy + core::fmt::Debug + PartialEq + 'static;

    /// What kicks left over of a velocity.
    type Rest: Copy + core::fmt::Debug + PartialEq + 'static;

    /// Nothing left over.
    const NO_REST: Self::Rest;

    /// Bytes of a remainder in a snapshot.
    const REST_BYTES: usize;

    /// A position with nothing left over.
    #[must_use]
    fn place(self) -> Self::Place;

    /// The position nearest to a place.
    #[must_use]
    fn seen(place: Self::Place) -> Self;

    /// `place - from`, with as much of the remainder of the place as one of a velocity holds; a float rounds
    /// the difference.
    #[must_use]
    fn beyond(place: Self::Place, from: Self) -> (Self, Self::Rest);

    /// `2 about - place`, saturating.
    #[must_use]
    fn mirrored(place: Self::Place, about: Self) -> Self::Place;

    /// `place + factor * value / 2^halvings`, saturating; `halvings` is 0 or 1.
    #[must_use]
    fn moved(place: Self::Place, value: Self, factor: Self::Coef, halvings: u32) -> Self::Place;

    /// `place + num / 2^shift * value`, exact in fixed point; called with constants.
    #[must_use]
    fn moved_dyadic(place: Self::Place, value: Self, num: u32, shift: u32) -> Self::Place;

    /// `place + h * v / 2^halvings` for a velocity with its remainder.
    #[must_use]
    fn drifted(
        place: Self::Place,
        kept: (Self, Self::Rest),
        h: Self::Coef,
        halvings: u32,
    ) -> Self::Place;

    /// `place + num / 2^shift * v`, in the same way; called with constants.
    #[must_use]
    fn drifted_dyadic(
        place: Self::Place,
        kept: (Self, Self::Rest),
        num: u32,
        shift: u32,
    ) -> Self::Place;

    /// A velocity and its remainder after `+ factor * value`.
    #[must_use]
    fn kicked(kept: (Self, Self::Rest), value: Self, factor: Self::Coef) -> (Self, Self::Rest);

    /// The same after `+ factor * value` for a value with its remainder.
    #[must_use]
    fn kicked_as(
        kept: (Self, Self::Rest),
        value: (Self, Self::Rest),
        factor: Self::Coef,
    ) -> (Self, Self::Rest);

    /// The same after `v = -v`.
    #[must_use]
    fn turned(kept: (Self, Self::Rest)) -> (Self, Self::Rest);

    /// The same after losing `loss` of both, for a loss from 0 to 1: towards rest and never past it.
    /// In fixed point at least one unit of the remainder goes, so that a body comes to rest.
    #[must_use]
    fn damped(kept: (Self, Self::Rest), loss: Self::Coef) -> (Self, Self::Rest);

    /// Both parts of a velocity after `+ impulse / m`. In fixed point their momentum changes by exactly
    /// the impulse: up to `2^15` kg, and while the velocity stays within its range.
    #[must_use]
    fn pushed(
        kept: [(Self, Self::Rest); 2],
        impulse: [Self; 2],
        inv_mass: Self::InvMass,
    ) -> [(Self, Self::Rest); 2];

    /// Its momentum, remainder and all; exact in fixed point.
    #[must_use]
    fn momentum(kept: (Self, Self::Rest), inv_mass: Self::InvMass) -> f64;

    /// What a place holds beyond the position that is seen, for a hash: equal for equal places.
    #[must_use]
    fn left_over(place: Self::Place) -> u64;

    /// What a remainder holds, for a hash: equal for equal remainders, one NaN.
    #[must_use]
    fn rest_left_over(rest: Self::Rest) -> u64;

    /// The bits of a place in two halves of a scalar's size.
    #[must_use]
    fn halves(place: Self::Place) -> [u64; 2];

    /// The place of those halves; `None` where they have more bits than a scalar.
    #[must_use]
    fn of_halves(halves: [u64; 2]) -> Option<Self::Place>;

    /// The exact bits of a remainder, in its [`REST_BYTES`](Carry::REST_BYTES) lowest bytes.
    #[must_use]
    fn rest_bits(rest: Self::Rest) -> u64;

    /// The remainder of those bits; `None` where no remainder has them.
    #[must_use]
    fn of_rest_bits(bits: u64) -> Option<Self::Rest>;
}
