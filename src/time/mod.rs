//! Time is a count of ticks, never a sum of rounded lengths.
//!
//! ```
//! use fixstep::{Accumulator, Step};
//! let step = Step::<f32>::hz(50)?;
//! let mut clock = Accumulator::new(1000, step.seconds(), 4)?; // milliseconds
//! assert_eq!(clock.advance(45).steps, 2); // two steps of 20 ms
//! # Ok::<(), fixstep::Error>(())
//! ```

mod accumulator;
mod between;
mod dyadic;
mod revolve;
mod step;
mod timestep;

use crate::ratio::Ratio;
use crate::scalar::Scalar;

pub use accumulator::{Accumulator, Due};
pub use between::Between;
pub use dyadic::DyadicStep;
pub use revolve::Revolve;
pub use step::Step;
pub use timestep::TimeStep;

/// An instant: a whole or half number of steps since the start.
///
/// All steps count with the length of the present one. If a world changes its step, its time changes too.
///
/// ```
/// use fixstep::{DyadicStep, Now, dec};
/// let step = DyadicStep::<f32, 1, 2>::new()?; // 1/4 s
/// let time = Now::middle(&step, 6).time();
/// assert_eq!(time.half_ticks(), 13);
/// assert_eq!(time.elapsed(), Some(dec!(1.625)));
/// assert_eq!(time.seconds::<f32>(), 1.625);
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[must_use]
pub struct Time {
    half_ticks: u64,
    seconds: Ratio,
}

impl Time {
    /// The time since the start as a scalar, rounded once. It saturates at the end of the range.
    /// A time that needs more than 62 bits is first cut to 62.
    ///
    /// It costs a 128-bit division, which is slow on a small core. If a force oscillates for long,
    /// reduce [`half_ticks`](Time::half_ticks) modulo its period in integers.
    #[must_use]
    pub fn seconds<S: Scalar>(self) -> S {
        let num = self.half_ticks as u128 * self.seconds.num() as u128;
        let den = self.seconds.den() as u128 * 2;
        Ratio::quotient(num, den)
            .and_then(S::ratio)
            .unwrap_or(S::MAX)
    }

    /// Half steps since the start: even at the start of a step, odd in its middle.
    #[must_use]
    pub fn half_ticks(self) -> u64 {
        self.half_ticks
    }

    /// The exact time since the start. `None` if it needs more than 62 bits.
    #[must_use]
    pub fn elapsed(self) -> Option<Ratio> {
        let num = i64::try_from(self.half_ticks)
            .ok()?
            .checked_mul(self.seconds.num())?;
        Ratio::new(num, self.seconds.den().checked_mul(2)?).ok()
    }
}

/// The instant of a stage, and its step.
///
/// All stages of one step use the same `step`, so that they round alike.
///
/// ```
/// use fixstep::{DyadicStep, Now, dec};
/// let step = DyadicStep::<f32, 1, 1>::new()?; // 1/2 s
/// let now = Now::end(&step, 4);
/// assert_eq!(now.tick(), 4);
/// assert_eq!(now.time().elapsed(), Some(dec!(2.5)));
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Now<H> {
    /// The step with the roundings of this tick.
    pub step: H,
    tick: u64,
    /// Half steps since the start of this step.
    halves: u8,
}

impl<H> Now<H> {
    /// The start of step `tick`.
    #[inline]
    pub fn start<S: Scalar>(step: &H, tick: u64) -> Self
    where
        H: TimeStep<S>,
    {
        Now {
            step: step.at(tick),
            tick,
            halves: 0,
        }
    }

    /// The middle of step `tick`.
    #[inline]
    pub fn middle<S: Scalar>(step: &H, tick: u64) -> Self
    where
        H: TimeStep<S>,
    {
        Now {
            step: step.at(tick),
            tick,
            halves: 1,
        }
    }

    /// The end of step `tick`.
    #[inline]
    pub fn end<S: Scalar>(step: &H, tick: u64) -> Self
    where
        H: TimeStep<S>,
    {
        Now {
            step: step.at(tick),
            tick,
            halves: 2,
        }
    }

    /// Number of the present step; the first is 0.
    #[must_use]
    pub fn tick(&self) -> u64 {
        self.tick
    }

    /// The instant at which forces are evaluated.
    pub fn time<S: Scalar>(&self) -> Time
    where
        H: TimeStep<S>,
    {
        let half_ticks = self
            .tick
            .saturating_mul(2)
            .saturating_add(self.halves as u64);
        Time {
            half_ticks,
            seconds: self.step.seconds(),
        }
    }
}
