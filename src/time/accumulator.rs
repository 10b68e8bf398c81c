//! The number of steps to make per frame: counts of a clock in, whole steps and a remainder out.
//!
//! ```text
//! one count is  a / b  of a step,  a and b without common divisor
//! remainder + counts a = steps b + remainder'        0 <= remainder' < b
//! ```
//!
//! All arithmetic is in integers. After any number of frames the steps are `floor(elapsed / h)`, so two
//! clocks never drift apart. A frame that took too long makes at most `max_steps` steps. The other whole
//! steps are dropped and reported; without this limit each frame could take longer than the one before.
//! Source of the scheme: Fiedler, "Fix Your Timestep!" (Gaffer on Games), which uses floats.

use core::num::NonZero;

use crate::error::Error;
use crate::ratio::Ratio;
use crate::scalar::{Word, divide_words};

/// Converts counts of a clock (microseconds, timer ticks, display frames) into steps.
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
    remainder: u64,
    max_steps: u32,
}

/// The steps to make in a frame, and those it drops.
///
/// ```
/// use fixstep::{Accumulator, dec};
/// let mut clock = Accumulator::new(1000, dec!(0.02), 3)?; // milliseconds, 20 ms a step
/// let due = clock.advance(95); // four whole steps and 15 ms
/// assert_eq!((due.steps, due.dropped), (3, 1));
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
#[must_use]
pub struct Due {
    /// Steps to make now.
    pub steps: u32,
    /// Steps that are never made; the scene loses their time. Zero unless the frame was too long.
    /// Saturates if more than 2^64 are due.
    pub dropped: u64,
}

impl Accumulator {
    /// An accumulator for a clock with `counts_per_second` and steps of `seconds`. A frame makes at most
    /// `max_steps`.
    ///
    /// Returns an error if an argument is zero or negative. The common unit of clock and step must be at
    /// least `2^-62` of the step.
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
            remainder: 0,
            max_steps,
        })
    }

    /// Adds `counts` and returns the steps that are due.
    #[inline]
    pub fn advance(&mut self, counts: u64) -> Due {
        let (due, remainder) = match self.after_a_frame(counts) {
            Some(due) => due,
            None => self.after_a_long_time(counts),
        };
        self.remainder = remainder;
        let steps = due.min(self.max_steps as u64);
        Due {
            steps: steps as u32,
            dropped: due - steps,
        }
    }

    /// Whole steps and remainder, if one word holds them. It does for a clock of microseconds at 60 Hz,
    /// and for any clock whose common unit with the step is not too short.
    #[allow(clippy::unnecessary_cast, reason = "a word may be shorter")]
    #[inline]
    fn after_a_frame(&self, counts: u64) -> Option<(u64, u64)> {
        let word = |n: u64| Word::try_from(n).ok();
        let per_step = NonZero::new(word(self.per_step.get())?)?;
        let more = word(counts)?.checked_mul(word(self.per_count)?)?;
        // Less than a step.
        let total = more.checked_add(self.remainder as Word)?;
        let (due, remainder) = divide_words(total, per_step)?;
        Some((due as u64, remainder as u64))
    }

    /// The same for any number of counts. Saturates if 64 bits cannot hold the steps.
    #[cold]
    #[inline(never)]
    fn after_a_long_time(&self, counts: u64) -> (u64, u64) {
        let per_step = self.per_step.get();
        let count = multiplied(self.per_count, (0, 1), per_step);
        let (due, remainder) = multiplied(counts, count, per_step);
        let remainder = remainder + self.remainder;
        match remainder.checked_sub(per_step) {
            Some(less) => (due.saturating_add(1), less),
            None => (due, remainder),
        }
    }

    /// The part of a step that has passed since the last due step: exact, from 0 to below 1.
    #[must_use]
    pub fn fraction(&self) -> Ratio {
        Ratio::fraction(self.remainder, self.per_step)
    }

    /// Discards the part of a step that has passed. Call it after a pause or for a new scene.
    pub fn reset(&mut self) {
        self.remainder = 0;
    }
}

/// `n` times the whole steps and the remainder `part`. `part` is at most one step; the result's is less.
///
/// It works bit by bit, from the highest. A 64-bit division is a long routine on a core without one.
/// This case is rare: it needs minutes without a frame, or a clock and a step with a small common unit.
#[inline(never)]
fn multiplied(mut n: u64, (steps, part): (u64, u64), per_step: u64) -> (u64, u64) {
    let (mut due, mut remainder) = (0_u64, 0_u64);
    for _ in 0..u64::BITS {
        // Less than three steps, and `new` limits a step to 2^62.
        (due, remainder) = (due.saturating_add(due), 2 * remainder);
        if n >> 63 != 0 {
            (due, remainder) = (due.saturating_add(steps), remainder + part);
        }
        while let Some(less) = remainder.checked_sub(per_step) {
            (due, remainder) = (due.saturating_add(1), less);
        }
        n <<= 1;
    }
    (due, remainder)
}

/// The greatest common divisor, by Euclid; both numbers are greater than zero.
fn common_divisor(a: u64, b: u64) -> NonZero<u64> {
    let (mut divisor, mut remainder) = (NonZero::new(a).unwrap_or(NonZero::<u64>::MIN), b);
    while let Some(by) = NonZero::new(remainder) {
        (divisor, remainder) = (by, divisor.get() % by);
    }
    divisor
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Which counts take the bit-by-bit path depends on the core. It must equal the host's division.
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
            let (remainder, counts) = (random() % per_step, random());
            let largest = (1 << 62, 1 << 62, (1 << 62) - 1, u64::MAX);
            let (per_count, per_step, remainder, counts) = match round {
                0 => largest,
                _ => (per_count, per_step, remainder, counts),
            };
            let clock = Accumulator {
                per_count,
                per_step: NonZero::new(per_step).unwrap_or(NonZero::<u64>::MIN),
                remainder,
                max_steps: 1,
            };
            let total = counts as u128 * per_count as u128 + remainder as u128;
            let due = u64::try_from(total / per_step as u128).unwrap_or(u64::MAX);
            let expected = (due, (total % per_step as u128) as u64);
            let after = clock.after_a_long_time(counts);
            assert_eq!(after, expected, "{clock:?} {counts}");
        }
    }
}
