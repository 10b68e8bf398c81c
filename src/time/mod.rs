//! Time is a count of ticks, never a sum of rounded lengths.

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

/// An instant: a whole or half number of steps since the start, all of one length. A world that
/// changes its step changes its clock with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[must_use]
pub struct Time {
    half_ticks: u64,
    seconds: Ratio,
}

impl Time {
    /// The time since the start as a scalar: rounded once, after a cut to 62 bits where it needs more;
    /// saturates at the end of the range.
    ///
    /// Made by a 128-bit division, dear on a small core. A force that oscillates for long does better
    /// to reduce [`half_ticks`](Time::half_ticks) by its period in integers.
    #[must_use]
    pub fn seconds<S: Scalar>(self) -> S {
        let num = self.half_ticks as u128 * self.seconds.num() as u128;
        let den = self.seconds.den() as u128 * 2;
        Ratio::quotient(num, den)
            .and_then(S::ratio)
            .unwrap_or(S::MAX)
    }

    /// Half steps since the start; even at the start of a step, odd in its middle.
    #[must_use]
    pub fn half_ticks(self) -> u64 {
        self.half_ticks
    }

    /// The time since the start, exactly; `None` when it needs more than 62 bits.
    #[must_use]
    pub fn elapsed(self) -> Option<Ratio> {
        let num = i64::try_from(self.half_ticks)
            .ok()?
            .checked_mul(self.seconds.num())?;
        Ratio::new(num, self.seconds.den().checked_mul(2)?).ok()
    }
}

/// The instant at which a stage works, and the step it works for.
///
/// All stages of one step share one `Now`, so that they round alike.
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Now<H> {
    /// The step, as this tick uses it.
    pub step: H,
    tick: u64,
    /// Half steps since the start of this one.
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

    /// Number of the step that is being made; the first is 0.
    #[must_use]
    pub fn tick(&self) -> u64 {
        self.tick
    }

    /// The instant at which forces are taken.
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
