//! A timestep with its length in the type: exactly `NUM / 2^SHIFT` seconds.
//!
//! If `NUM` is 1 a product is a shift, at half the cost on a core without a long multiply.

use super::{Revolve, TimeStep};
use crate::error::Error;
use crate::ratio::Ratio;
use crate::scalar::{Carry, Factor, Scalar};

/// A timestep of exactly `NUM / 2^SHIFT` seconds, known to the compiler.
///
/// `NUM` is from 1 to `2^24` and `SHIFT` from 1 to 29. Other values do not compile.
///
/// On a core without a long multiply it costs less than [`Step`], most of all with `NUM` 1. That holds
/// as long as `NUM` is below `2^15` and `SHIFT` above 16. On other cores [`Step`] costs less.
///
/// Ties round away from zero in every tick, so a fast oscillation runs ahead. [`Step`] alternates them.
/// The error after 10^6 steps, for an `I16F16` that oscillates at 1 Hz with 16 m:
///
/// | step | error |
/// |---|---|
/// | `DyadicStep` of 1/64 s | 8 cm |
/// | [`Step`] at 64 Hz | 4 mm |
///
/// ```
/// use fixstep::{DyadicStep, Step, TimeStep, fixed::types::I16F16};
/// let step = DyadicStep::<I16F16, 1, 6>::new()?; // 1/64 s
/// assert_eq!(step.times(I16F16::ONE), 0.015625);
/// let frame = DyadicStep::<f32, 4389, 18>::new()?; // one picture of a Game Boy Advance
/// assert_eq!(frame.times(1.0), 4389.0 / 262144.0);
/// # Ok::<(), fixstep::Error>(())
/// ```
///
/// ```compile_fail
/// let step = fixstep::DyadicStep::<f32, 1, 40>::new();
/// ```
///
/// [`Step`]: crate::Step
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DyadicStep<S: Scalar, const NUM: u32, const SHIFT: u32> {
    coef: S::Coef,
}

impl<S: Scalar, const NUM: u32, const SHIFT: u32> DyadicStep<S, NUM, SHIFT> {
    const SECONDS: Ratio = {
        assert!(NUM >= 1 && NUM <= 1 << 24 && SHIFT >= 1 && SHIFT <= 29);
        match Ratio::new(NUM as i64, 1 << SHIFT) {
            Ok(seconds) => seconds,
            Err(_) => unreachable!(),
        }
    };

    /// Its length, exactly.
    #[inline]
    #[must_use]
    pub const fn seconds(&self) -> Ratio {
        Self::SECONDS
    }

    /// The step. An error only if the coefficients of the scalar cannot hold its length.
    #[inline]
    pub fn new() -> Result<Self, Error> {
        let (field, value) = ("seconds", Self::SECONDS);
        let coef = S::Coef::new(value).ok_or(Error::OutOfRange { field, value })?;
        Ok(DyadicStep { coef })
    }
}

impl<S: Scalar, const NUM: u32, const SHIFT: u32> TimeStep<S> for DyadicStep<S, NUM, SHIFT> {
    #[inline]
    fn coef(&self) -> S::Coef {
        self.coef
    }

    #[inline(always)]
    fn times(&self, rate: S) -> S {
        rate.dyadic(NUM, SHIFT)
    }

    #[inline(always)]
    fn half_times(&self, rate: S) -> S {
        rate.dyadic(NUM, SHIFT + 1)
    }

    #[inline(always)]
    fn carry(&self, position: S::FinePosition, kept: (S, S::Remainder)) -> S::FinePosition
    where
        S: Carry,
    {
        S::drifted_dyadic(position, kept, NUM, SHIFT)
    }

    #[inline(always)]
    fn carry_half(&self, position: S::FinePosition, kept: (S, S::Remainder)) -> S::FinePosition
    where
        S: Carry,
    {
        S::drifted_dyadic(position, kept, NUM, SHIFT + 1)
    }

    #[inline(always)]
    fn revolve<T: Revolve<S>>(&self, what: T) -> T {
        what.revolved_dyadic(NUM, SHIFT)
    }

    #[inline(always)]
    fn revolve_half<T: Revolve<S>>(&self, what: T) -> T {
        what.revolved_dyadic(NUM, SHIFT + 1)
    }

    #[inline]
    fn seconds(&self) -> Ratio {
        Self::SECONDS
    }
}
