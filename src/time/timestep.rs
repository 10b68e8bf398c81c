//! What forces and stages ask of a step: how `h v` is made.

use super::Revolve;
use crate::ratio::Ratio;
use crate::scalar::{Carry, Scalar};

/// A fixed timestep, with its length `h` in the forms that forces and stages need.
pub trait TimeStep<S: Scalar>: Copy {
    /// `h` as a coefficient, to be multiplied with others once per step.
    #[must_use]
    fn coef(&self) -> S::Coef;

    /// `h * rate`: nearest, odd, saturating.
    #[must_use]
    fn times(&self, rate: S) -> S;

    /// `h/2 * rate`.
    #[must_use]
    fn half_times(&self, rate: S) -> S;

    /// `h * v` added to a position that keeps what is rounded away, for a velocity with its remainder: only
    /// `h` itself, a coefficient, is rounded.
    #[inline]
    #[must_use]
    fn carry(&self, position: S::FinePosition, kept: (S, S::Remainder)) -> S::FinePosition
    where
        S: Carry,
    {
        S::drifted(position, kept, self.coef(), 0)
    }

    /// `h/2 * v`, in the same way.
    #[inline]
    #[must_use]
    fn carry_half(&self, position: S::FinePosition, kept: (S, S::Remainder)) -> S::FinePosition
    where
        S: Carry,
    {
        S::drifted(position, kept, self.coef(), 1)
    }

    /// `what` after `h`.
    #[inline(always)]
    #[must_use]
    fn revolve<T: Revolve<S>>(&self, what: T) -> T {
        what.revolved(self.coef(), 0)
    }

    /// `what` after `h/2`.
    #[inline(always)]
    #[must_use]
    fn revolve_half<T: Revolve<S>>(&self, what: T) -> T {
        what.revolved(self.coef(), 1)
    }

    /// `h` in seconds, exactly.
    #[must_use]
    fn seconds(&self) -> Ratio;

    /// The step as tick `tick` uses it: where a rounding is a toss-up, it goes one way in even
    /// ticks and the other way in odd ones. A step that has no other way returns itself.
    #[inline]
    #[must_use]
    fn at(&self, tick: u64) -> Self {
        let _ = tick;
        *self
    }
}
