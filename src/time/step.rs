//! The timestep: how long a step is, and how `h v` is made.
//!
//! Two kinds share one trait. [`Step`] takes any rate above 4 Hz at run time; in 32-bit fixed point
//! its `h` is off by at most 9.4e-10 of itself on the mean of two ticks. [`DyadicStep`] has its length
//! in the type, `NUM / 2^SHIFT` seconds: exact, and where `NUM` is 1 a shift, half the price on a core
//! without a long multiply.

use crate::error::Error;
use crate::ratio::Ratio;
use crate::scalar::{Carry, Factor, Scalar};

/// What goes on at a rate of its own: an angle with its spin.
pub trait Revolve<S: Scalar> {
    /// By `h / 2^halvings` times its rate; `halvings` is 0 or 1.
    #[must_use]
    fn revolved(self, h: S::Coef, halvings: u32) -> Self;

    /// By `num / 2^shift` times its rate, exactly as far as it can hold it; called with constants.
    #[must_use]
    fn revolved_dyadic(self, num: u32, shift: u32) -> Self;
}

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

/// A timestep of any length below a quarter second.
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
    /// A step of `1 / rate`, rate in steps per second. Refuses zero and negative rates, rates up
    /// to 4 Hz (longer steps: [`DyadicStep`]) and those whose length would become zero.
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

    /// A step of `seconds`. Refuses what [`hz`](Step::hz) refuses.
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

/// A timestep of exactly `NUM / 2^SHIFT` seconds, known to the compiler.
///
/// `NUM` from 1 to `2^24`, `SHIFT` from 1 to 29; anything else does not compile.
///
/// On a core without a long multiply it is the cheaper step, above all with `NUM` 1 and as long as
/// `NUM` is below `2^15` and `SHIFT` above 16; on others [`Step`] is.
/// Ties go away from zero in every tick, so a fast oscillation runs ahead: by 8 cm in 10^6 steps for
/// an `I16F16` at 1 Hz, 16 m and 1/64 s, where [`Step`] at 64 Hz, which cancels its ties, is 4 mm off.
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

    /// The step. Refused only by a scalar whose coefficients cannot hold its length.
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
