//! A timestep of any rate above 4 Hz, chosen at run time.
//!
//! In 32-bit fixed point the mean of `h` over two ticks has a relative error of at most 9.4e-10.

use super::TimeStep;
use crate::error::Error;
use crate::ratio::Ratio;
use crate::scalar::{Factor, Scalar};

/// A timestep of any length below a quarter second. Use [`DyadicStep`](crate::DyadicStep) for longer steps.
///
/// ```
/// use fixstep::{dec, Step, TimeStep, fixed::types::I16F16};
/// let step = Step::<I16F16>::hz(60)?;
/// assert_eq!(step.times(I16F16::ONE).to_bits(), 1092); // 65536 / 60 = 1092.27
/// assert!(Step::<I16F16>::hz(0).is_err());
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step<S: Scalar> {
    span: [S::Span; 2],
    half: [S::Span; 2],
    coef: S::Coef,
    seconds: Ratio,
}

impl<S: Scalar> Step<S> {
    /// A step of `1 / rate` seconds. `rate` is in steps per second and must be above 4 Hz.
    /// It is an error if the length rounds to zero in this scalar.
    #[inline]
    pub fn hz(rate: impl Into<Ratio>) -> Result<Step<S>, Error> {
        let (field, value) = ("rate", rate.into());
        let seconds = value.inverse().ok_or(Error::NotPositive { field, value })?;
        Self::with_length(seconds, field, value)
    }

    /// Its length, exactly.
    #[inline]
    #[must_use]
    pub const fn seconds(&self) -> Ratio {
        self.seconds
    }

    /// A step of `seconds`: above zero and below a quarter second, as in [`hz`](Step::hz).
    #[inline]
    pub fn from_seconds(seconds: impl Into<Ratio>) -> Result<Step<S>, Error> {
        let (field, value) = ("seconds", seconds.into());
        if value.num() <= 0 {
            return Err(Error::NotPositive { field, value });
        }
        Self::with_length(value, field, value)
    }

    #[inline(always)]
    fn with_length(seconds: Ratio, field: &'static str, value: Ratio) -> Result<Step<S>, Error> {
        let error = Error::OutOfRange { field, value };
        if seconds.num() as u128 * 4 >= seconds.den() as u128 {
            return Err(error);
        }
        let halved = seconds.halved().ok_or(error)?;
        Ok(Step {
            span: S::spans(seconds).ok_or(error)?,
            half: S::spans(halved).ok_or(error)?,
            coef: S::Coef::new(seconds).ok_or(error)?,
            seconds,
        })
    }
}

impl<S: Scalar> TimeStep<S> for Step<S> {
    #[inline]
    fn coef(&self) -> S::Coef {
        self.coef
    }

    #[inline]
    fn times(&self, rate: S) -> S {
        self.span[0].scale(rate)
    }

    #[inline]
    fn half_times(&self, rate: S) -> S {
        self.half[0].scale(rate)
    }

    #[inline]
    fn seconds(&self) -> Ratio {
        self.seconds
    }

    #[inline]
    fn at(&self, tick: u64) -> Self {
        if tick & 1 == 0 {
            return *self;
        }
        let ([span, other], [half, other_half]) = (self.span, self.half);
        Step {
            span: [other, span],
            half: [other_half, half],
            ..*self
        }
    }
}
