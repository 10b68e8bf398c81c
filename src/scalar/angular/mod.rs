//! Number types for bodies that rotate: their angles, sines and torques.
//!
//! A spin is a number of turns a second. A step adds a fraction of a turn to an angle; at a dyadic rate
//! this is a shift, and exact. In radians it would be a product with `1/2π`, which no number type holds exactly.
//! π stands only in the coefficients for a moment of inertia (`1 / 2πI`) and a speed (`2π r`).
//!
//! `fixed.rs` and `float.rs` have the derivations.

mod circle;
mod fixed;
mod float;
mod turns;

use core::fmt::Debug;

use super::{Carry, Scalar};

pub use turns::Turns;

/// A number type in which bodies can rotate.
///
/// ```
/// use fixstep::{Angular, dec, fixed::types::I16F16, scalar::Turns};
/// let quarter: u32 = Turns::nearest(dec!(0.25));
/// let v = [I16F16::lit("3"), I16F16::lit("0")];
/// let [x, y] = I16F16::rotated(I16F16::circle(quarter), v);
/// assert!(x == 0 && y == 3);
/// ```
pub trait Angular: Scalar {
    /// An angle, all bits of which are a fraction of a turn.
    type Turns: Turns;

    /// A sine or a cosine.
    type Unit: Copy + Debug + PartialEq + 'static;

    /// `2π`.
    const TAU: Self::Coef;

    /// The inverse mass of a body that no force moves: zero.
    const INFINITE_MASS: Self::InvMass;

    /// `angle + h/2^halvings * spin`: nearest, odd; `halvings` is 0 or 1.
    #[must_use]
    fn advanced(angle: Self::Turns, spin: Self, h: Self::Coef, halvings: u32) -> Self::Turns;

    /// `angle + num/2^shift * spin`: exact where the angle has the bits, else nearest; called with
    /// constants.
    #[must_use]
    fn advanced_dyadic(angle: Self::Turns, spin: Self, num: u32, shift: u32) -> Self::Turns;

    /// `part` from 0 to 1 of an angle, which is taken from -1/2 to 1/2 turns.
    #[must_use]
    fn part_of(angle: Self::Turns, part: Self::Coef) -> Self::Turns;

    /// Cosine and sine. Odd and even to the bit, as are their reflections at an eighth of a turn; off by
    /// at most a unit of `2^-30` in 32-bit fixed point, in `f32` by its rounding too.
    #[must_use]
    fn circle(angle: Self::Turns) -> [Self::Unit; 2];

    /// `v` rotated by the angle of that cosine and sine: each component rounded once, saturating.
    #[must_use]
    fn rotated(circle: [Self::Unit; 2], v: [Self; 2]) -> [Self; 2];

    /// `-unit`.
    #[must_use]
    fn opposite(unit: Self::Unit) -> Self::Unit;

    /// The nearest scalar to a sine or a cosine.
    #[must_use]
    fn from_unit(unit: Self::Unit) -> Self;

    /// `sum * factor`, saturating: to half a unit and `2^-30` of itself in 32 bits.
    #[must_use]
    fn weighed(sum: Self::Sum, factor: Self::Coef) -> Self;
}

/// A number type in which bodies can rotate and be *carried*: they keep what rounding loses.
///
/// ```
/// use fixstep::{Carry, CarryAngular, dec, fixed::types::I16F16, scalar::Turns};
/// let quarter: u32 = Turns::nearest(dec!(0.25));
/// let spin = (I16F16::lit("1"), I16F16::NO_REMAINDER); // one turn a second
/// let half = I16F16::fine_rotated_dyadic(I16F16::fine(quarter), spin, 1, 2); // 1/4 s
/// assert_eq!(I16F16::coarse(half), u32::nearest(dec!(0.5)));
/// ```
pub trait CarryAngular: Angular + Carry {
    /// A fine angle: an angle with its rounding remainder.
    type Fine: Copy + Debug + Eq + 'static;

    /// The fine angle whose remainder is zero.
    #[must_use]
    fn fine(angle: Self::Turns) -> Self::Fine;

    /// The angle nearest to a fine one.
    #[must_use]
    fn coarse(fine: Self::Fine) -> Self::Turns;

    /// `fine + h/2^halvings * spin`, for a spin with its remainder.
    #[must_use]
    fn fine_rotated(
        fine: Self::Fine,
        kept: (Self, Self::Remainder),
        h: Self::Coef,
        halvings: u32,
    ) -> Self::Fine;

    /// `fine + num/2^shift * spin`, in the same way; called with constants.
    #[must_use]
    fn fine_rotated_dyadic(
        fine: Self::Fine,
        kept: (Self, Self::Remainder),
        num: u32,
        shift: u32,
    ) -> Self::Fine;

    /// A spin and its remainder after `+ factor * sum`.
    #[must_use]
    fn twisted(
        kept: (Self, Self::Remainder),
        sum: Self::Sum,
        factor: Self::Coef,
    ) -> (Self, Self::Remainder);

    /// A spin with its remainder, for reports.
    #[must_use]
    fn kept_to_f64(kept: (Self, Self::Remainder)) -> f64;

    /// The bits of a fine angle, upper half first.
    #[must_use]
    fn fine_halves(fine: Self::Fine) -> [u64; 2];

    /// The fine angle of those halves; `None` where they have more bits than an angle.
    #[must_use]
    fn from_fine_halves(halves: [u64; 2]) -> Option<Self::Fine>;
}
