//! How many steps a frame is due: elapsed counts of a clock in, whole steps and a rest out.
//!
//! ```text
//! one count is  a / b  of a step,  a and b without common divisor
//! rest + counts a = steps b + rest'        0 <= rest' < b
//! ```
//!
//! All of it in integers, so that after any number of frames the steps are `floor(elapsed / h)`: no
//! clock drifts against another. A frame that took too long makes no more than `max_steps`; the
//! rest of its whole steps is dropped and reported, or each frame would take longer than the one
//! before. Source of the scheme: Fiedler, "Fix Your Timestep!" (Gaffer on Games), who keeps it in floats.

use core::num::NonZero;

use crate::error::Error;
use crate::ratio::Ratio;

/// Turns the counts of a clock (microseconds, timer ticks, frames of a display) into steps.
///
/// ```
/// use fixstep::{Accumulator, Step};
/// let step = Step::<f32>::hz(60)?;
/// let mut clock = Accumulator::new(1_000_000, step.seconds(), 4)?; // microseconds
/// assert_eq!(clock.advance(16_000).steps, 0); // 16.67 ms make a step
/// assert_eq!(clock.advance(18_000).steps, 2);
/// assert_eq!(clock.fraction(), fixstep::dec!(0.04)); // 34 ms are 2.04 steps
/// let stall = clock.advance(3_600_000_000);
/// assert_eq!((stall.steps, stall.dropped), (4, 215_996)); // an hour is 216,000
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Accumulator {
    per_count: u64,
    per_step: NonZero<u64>,
    rest: u64,
    max_steps: u32,
}

/// What a frame is due.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
#[must_use]
pub struct Due {
    /// Steps to make now.
    pub steps: u32,
    /// Steps that are never made: time the scene has lost. Zero unless the frame was too long;
    /// saturates where more than 2^64 are due.
    pub dropped: u64,
}

impl Accumulator {
    /// For a clock of so many counts per second and steps of `seconds`; a frame makes `max_steps` or
    /// fewer.
    ///
    /// Refuses a clock that stands still, steps of no length, no steps at all, and a clock and a
    /// step whose common unit is below `2^-62` of the step.
    pub fn new(
        counts_per_second: u32,
        seconds: impl Into<Ratio>,
        max_steps: u32,
    ) -> Result<Self, Error> {
        let positive = |field, value: Ratio| match value.num() {
            ..=0 => Err(Error::NotPositive { field, value }),
            _ => Ok(value),
        };
        positive("counts_per_second", Ratio::whole(counts_per_second))?;
        positive("max_steps", Ratio::whole(max_steps))?;
        let (field, value) = ("seconds", positive("seconds", seconds.into())?);
        // One count is den / (num counts_per_second) of a step; in lowest terms it has to fit.
        let (num, den, counts) = (value.num() as u64, value.den(), counts_per_second as u64);
        let by = common_divisor(den, counts);
        let (den, counts) = (den / by, counts / by);
        let by = common_divisor(den, num);
        let per_step = (num / by)
            .checked_mul(counts)
            .filter(|&step| step <= 1 << 62);
        let error = Error::OutOfRange { field, value };
        Ok(Accumulator {
            per_count: den / by,
            per_step: per_step.and_then(NonZero::new).ok_or(error)?,
            rest: 0,
            max_steps,
        })
    }

    /// The steps due after `counts` more.
    #[inline]
    pub fn advance(&mut self, counts: u64) -> Due {
        let more = counts.checked_mul(self.per_count);
        let (due, rest) = match more.and_then(|more| more.checked_add(self.rest)) {
            Some(total) => (total / self.per_step, total % self.per_step),
            None => self.after_a_long_time(counts),
        };
        self.rest = rest;
        let steps = due.min(self.max_steps as u64);
        Due {
            steps: steps as u32,
            dropped: due - steps,
        }
    }

    /// The same where the product needs more than 64 bits: bit by bit, from the highest. No division
    /// of 128 bits is linked for a case that a clock meets once in a lifetime.
    #[cold]
    #[inline(never)]
    fn after_a_long_time(&self, counts: u64) -> (u64, u64) {
        let (whole, part) = (
            self.per_count / self.per_step,
            self.per_count % self.per_step,
        );
        let (mut due, mut rest) = (0_u64, 0);
        for bit in (0..u64::BITS).rev() {
            let (more, after) = match counts >> bit & 1 {
                0 => (0, 0),
                _ => (whole, part),
            };
            // Below three steps of at most 2^62.
            let total = 2 * rest + after;
            due = due.saturating_mul(2).saturating_add(more);
            due = due.saturating_add(total / self.per_step);
            rest = total % self.per_step;
        }
        let total = rest + self.rest;
        (
            due.saturating_add(total / self.per_step),
            total % self.per_step,
        )
    }

    /// The part of a step that has passed since the last one that was due: from 0 to below 1, exact.
    #[must_use]
    pub fn fraction(&self) -> Ratio {
        Ratio::fraction(self.rest, self.per_step)
    }

    /// Forgets the part of a step that has passed: after a pause, or a new scene.
    pub fn reset(&mut self) {
        self.rest = 0;
    }
}

/// Euclid's; of numbers greater than zero.
fn common_divisor(a: u64, b: u64) -> NonZero<u64> {
    let (mut divisor, mut rest) = (NonZero::new(a).unwrap_or(NonZero::<u64>::MIN), b);
    while let Some(by) = NonZero::new(rest) {
        (divisor, rest) = (by, divisor.get() % by);
    }
    divisor
}
