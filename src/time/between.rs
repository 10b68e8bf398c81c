//! Interpolation between two steps, for drawing.
//!
//! ```text
//! chord   x0 + α (x1 - x0)
//! bow     -α (1 - α) h/2 (v1 - v0)
//! ```
//!
//! A method with one velocity per step moves along the chord. A method for constant acceleration moves
//! along the chord plus the bow. It goes from `x0`, `v0` to `x1`, `v1`, with `x1 - x0 = h/2 (v0 + v1)`.
//! Each [`Method`](crate::Method) selects its own formula. A *flow* is a force that replaces the drift by
//! its exact solution, such as an exact spring. It rotates by `h ω` within a step. A parabola cannot
//! follow that if `h ω` is 1 or more.

use crate::error::Error;
use crate::ratio::Ratio;
use crate::scalar::{Factor, Scalar};
use crate::time::TimeStep;
use crate::vec2::Vec2;

/// A part α of a step, as coefficients. Make it once per picture and use it for all bodies.
///
/// ```
/// use fixstep::{Between, DyadicStep, dec, vec2};
/// let step = DyadicStep::<f32, 1, 6>::new()?;
/// let quarter = Between::new(dec!(0.25), &step)?;
/// assert_eq!(quarter.chord(vec2(0, 0)?, vec2(4, 8)?), vec2(1, 2)?);
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Between<S: Scalar> {
    part: S::Coef,
    bow: S::Coef,
}

impl<S: Scalar> Between<S> {
    /// `part` is from 0 (the state before) to 1 (the state after). Any other value is an error.
    /// [`Accumulator::fraction`](crate::Accumulator::fraction) returns such a part.
    pub fn new(part: impl Into<Ratio>, step: &impl TimeStep<S>) -> Result<Self, Error> {
        let (field, value) = ("part", part.into());
        let error = Error::OutOfRange { field, value };
        if value.num() < 0 || value.num() as u64 > value.den() {
            return Err(error);
        }
        // A value too small for a coefficient would move a body by less than one unit.
        let coef = |ratio| S::Coef::new(ratio).unwrap_or(S::ZERO.coef());
        let (num, den) = (value.num() as u64, value.den());
        let rest = Ratio::nearest((den - num) as u128, 2 * den as u128).ok_or(error)?;
        let part = coef(value);
        let bow = S::product(S::product(part, coef(rest)), step.coef());
        Ok(Between { part, bow })
    }

    /// The part, as a coefficient.
    pub(crate) const fn part(&self) -> S::Coef {
        self.part
    }

    /// The point on the straight line from `before` to `after`.
    #[inline]
    #[must_use]
    pub fn chord(&self, before: Vec2<S>, after: Vec2<S>) -> Vec2<S> {
        before + (after - before).scaled(self.part)
    }

    /// The offset of the path from that line if the velocity changes by `change` in the step.
    #[inline]
    #[must_use]
    pub fn bow(&self, change: Vec2<S>) -> Vec2<S> {
        -change.scaled(self.bow)
    }
}
