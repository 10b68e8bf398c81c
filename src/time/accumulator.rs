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
use crate::scalar::{Word, divide_words};

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
        let by = common_divisor(num, den);
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
        let (due, rest) = match self.after_a_frame(counts) {
            Some(due) => due,
            None => self.after_a_long_time(counts),
        };
        self.rest = rest;
        let steps = due.min(self.max_steps as u64);
        Due {
            steps: steps as u32,
            dropped: due - steps,
        }
    }

    /// Whole steps and rest, as long as one word holds them: so with a clock of microseconds at 60 Hz, and
    /// whatever else has a common unit with the step that is not too short.
    #[allow(clippy::unnecessary_cast, reason = "a word may be shorter")]
    #[inline]
    fn after_a_frame(&self, counts: u64) -> Option<(u64, u64)> {
        let word = |n: u64| Word::try_from(n).ok();
        let per_step = NonZero::new(word(self.per_step.get())?)?;
        let more = word(counts)?.checked_mul(word(self.per_count)?)?;
        // Less than a step.
        let total = more.checked_add(self.rest as Word)?;
        let (due, rest) = divide_words(total, per_step)?;
        Some((due as u64, rest as u64))
    }

    /// The same for any number of counts; more steps than 64 bits hold saturate.
    #[cold]
    #[inline(never)]
    fn after_a_long_time(&self, counts: u64) -> (u64, u64) {
        let per_step = self.per_step.get();
        let count = multiplied(self.per_count, (0, 1), per_step);
        let (due, rest) = multiplied(counts, count, per_step);
        let rest = rest + self.rest;
        match rest.checked_sub(per_step) {
            Some(less) => (due.saturating_add(1), less),
            None => (due, rest),
        }
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

/// `n` times so many steps and a rest, which is at most one step and ends below one.
///
/// Bit by bit, from the highest: a division of 64 bits is a long routine on a core that has none, for what
/// its clock meets after minutes, or where it and the step share no large unit.
#[inline(never)]
fn multiplied(mut n: u64, (steps, part): (u64, u64), per_step: u64) -> (u64, u64) {
    let (mut due, mut rest) = (0_u64, 0_u64);
    for _ in 0..u64::BITS {
        // Below three steps of at most 2^62, as `new` refuses more.
        (due, rest) = (due.saturating_add(due), 2 * rest);
        if n >> 63 != 0 {
            (due, rest) = (due.saturating_add(steps), rest + part);
        }
        while let Some(less) = rest.checked_sub(per_step) {
            (due, rest) = (due.saturating_add(1), less);
        }
        n <<= 1;
    }
    (due, rest)
}

/// Euclid's; of numbers greater than zero.
fn common_divisor(a: u64, b: u64) -> NonZero<u64> {
    let (mut divisor, mut rest) = (NonZero::new(a).unwrap_or(NonZero::<u64>::MIN), b);
    while let Some(by) = NonZero::new(rest) {
        (divisor, rest) = (by, divisor.get() % by);
    }
    divisor
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The bit-by-bit way is taken by other counts on other cores: it is the division of the host.
    #[test]
    fn a_long_time_is_divided_as_a_frame_is() {
        let mut seed = 1_u64;
        let mut random = || {
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (seed ^ seed >> 32) >> (seed >> 58)
        };
        for round in 0..100_000 {
            let (per_count, per_step) = (random() >> 2, random() >> 2 | 1);
            let (rest, counts) = (random() % per_step, random());
            let largest = (1 << 62, 1 << 62, (1 << 62) - 1, u64::MAX);
            let (per_count, per_step, rest, counts) = match round {
                0 => largest,
                _ => (per_count, per_step, rest, counts),
            };
            let clock = Accumulator {
                per_count,
                per_step: NonZero::new(per_step).unwrap_or(NonZero::<u64>::MIN),
                rest,
                max_steps: 1,
            };
            let total = counts as u128 * per_count as u128 + rest as u128;
            let due = u64::try_from(total / per_step as u128).unwrap_or(u64::MAX);
            let expected = (due, (total % per_step as u128) as u64);
            let after = clock.after_a_long_time(counts);
            assert_eq!(after, expected, "{clock:?} {counts}");
        }
    }
}
