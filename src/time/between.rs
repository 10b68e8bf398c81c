//! Where to draw between two steps.
//!
//! ```text
//! chord   x0 + α (x1 - x0)
//! bow     -α (1 - α) h/2 (v1 - v0)
//! ```
//!
//! The chord is the path of a method that moves with one velocity per step, the chord with its bow
//! that of a method for constant acceleration: from `x0` with `v0` to `x1` with `v1`, and
//! `x1 - x0 = h/2 (v0 + v1)`. Each [`Method`](crate::Method) says which is its own. A body that flows
//! (an exact spring) turns within a step by `h ω`, which no parabola follows from 1 on.

use crate::error::Error;
use crate::ratio::Ratio;
use crate::scalar::{Factor, Scalar};
use crate::time::TimeStep;
use crate::vec2::Vec2;

/// A part α of a step, as coefficients; made once for all bodies of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Between<S: Scalar> {
    part: S::Coef,
    bow: S::Coef,
}

impl<S: Scalar> Between<S> {
    /// `part` from 0 (the state before) to 1 (the state after), as
    /// [`Accumulator::fraction`](crate::Accumulator::fraction) gives it. Refuses anything else.
    pub fn new(part: impl Into<Ratio>, step: &impl TimeStep<S>) -> Result<Self, Error> {
        let (field, value) = ("part", part.into());
        let error = Error::OutOfRange { field, value };
        if value.num() < 0 || value.num() as u64 > value.den() {
            return Err(error);
        }
        // What is too small for a coefficient moves nothing by as much as a unit.
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

    /// On the straight line from `before` to `after`.
    #[inline]
    #[must_use]
    pub fn chord(&self, before: Vec2<S>, after: Vec2<S>) -> Vec2<S> {
        before + (after - before).scaled(self.part)
    }

    /// How far the path leaves that line while the velocity changes by `change`.
    #[inline]
    #[must_use]
    pub fn bow(&self, change: Vec2<S>) -> Vec2<S> {
        -change.scaled(self.bow)
    }
}
