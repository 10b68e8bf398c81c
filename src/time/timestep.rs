//! The trait of timesteps: how forces and stages compute `h v`.

use super::Revolve;
use crate::ratio::Ratio;
use crate::scalar::{Carry, Scalar};

/// A fixed timestep. It gives its length `h` in the forms that forces and stages need.
///
/// ```
/// use fixstep::{DyadicStep, TimeStep, dec};
/// let step = DyadicStep::<f32, 1, 2>::new()?; // 1/4 s
/// assert_eq!((step.times(8.0), step.half_times(8.0)), (2.0, 1.0));
/// assert_eq!(step.seconds(), dec!(0.25));
/// # Ok::<(), fixstep::Error>(())
/// ```
pub trait TimeStep<S: Scalar>: Copy {
    /// `h` as a coefficient, for products with other coefficients once per step.
    #[must_use]
    fn coef(&self) -> S::Coef;

    /// `h * rate`: rounded to nearest, odd in `rate`, saturating.
    #[must_use]
    fn times(&self, rate: S) -> S;

    /// `h/2 * rate`.
    #[must_use]
    fn half_times(&self, rate: S) -> S;

    /// Adds `h * v` to a *carried* position: one that keeps what rounding loses. `kept` is the velocity
    /// with its remainder. Only `h` itself, a coefficient, is rounded.
    #[inline]
    #[must_use]
    fn carry(&self, position: S::FinePosition, kept: (S, S::Remainder)) -> S::FinePosition
    where
        S: Carry,
    {
        S::drifted(position, kept, self.coef(), 0)
    }

    /// Adds `h/2 * v` in the same way.
    #[inline]
    #[must_use]
    fn carry_half(&self, position: S::FinePosition, kept: (S, S::Remainder)) -> S::FinePosition
    where
        S: Carry,
    {
        S::drifted(position, kept, self.coef(), 1)
    }

    /// `what` advanced by `h`.
    #[inline(always)]
    #[must_use]
    fn revolve<T: Revolve<S>>(&self, what: T) -> T {
        what.revolved(self.coef(), 0)
    }

    /// `what` advanced by `h/2`.
    #[inline(always)]
    #[must_use]
    fn revolve_half<T: Revolve<S>>(&self, what: T) -> T {
        what.revolved(self.coef(), 1)
    }

    /// The exact length `h` in seconds.
    #[must_use]
    fn seconds(&self) -> Ratio;

    /// The step with the roundings of tick `tick`. [`Step`](crate::Step) rounds `h` one way in even ticks
    /// and the other way in odd ticks, so that errors cancel. By default it is the step itself.
    #[inline]
    #[must_use]
    fn at(&self, tick: u64) -> Self {
        let _ = tick;
        *self
    }
}
