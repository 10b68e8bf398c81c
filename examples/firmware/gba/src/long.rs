//! A step of n / 2^32 s by the long multiply of the ARM7TDMI.
//!
//! ```text
//! h v = v n / 2^32          the upper word of a product
//! ```
//!
//! The library must take a `thumbv4t` core for one without a long multiply, since Thumb has none there.
//! In an ARM function this step costs a fifth less than a `DyadicStep` and half as much as a `Step`; in
//! a Thumb function it is a call, several times dearer. Its bits are those of the `DyadicStep` of the
//! same length: nearest, ties away from zero. Half a unit is added to the lower word, and one less below
//! zero.

use core::hint::black_box;

use fixstep::fixed::{FixedI32, types::extra::LeEqU32};
use fixstep::{Error, Factor, Ratio, Scalar, TimeStep};

/// A step of n / 2^32 s, n even, for 32-bit fixed point.
#[derive(Clone, Copy, Debug)]
pub struct Long<S: Scalar> {
    coef: S::Coef,
    seconds: Ratio,
    /// At run time: of a constant LLVM forgets that it has 32 bits, and multiplies twice.
    factor: i32,
    half: i32,
}

impl<S: Scalar> Long<S> {
    /// One picture of the console, 4389/2^18 s.
    pub const PICTURE: u32 = 4389 << 13;

    /// A step of `halves / 2^31` s. Refuses none, and more than an eighth of a second.
    pub fn new(halves: u32) -> Result<Long<S>, Error> {
        let seconds = Ratio::new(halves as i64, 1 << 31)?;
        let error = Error::OutOfRange {
            field: "halves",
            value: seconds,
        };
        if halves == 0 || halves > 1 << 28 {
            return Err(error);
        }
        Ok(Long {
            coef: S::Coef::new(seconds).ok_or(error)?,
            seconds,
            factor: black_box(halves as i32 * 2),
            half: black_box(halves as i32),
        })
    }

    /// Its length.
    #[must_use]
    pub fn seconds(&self) -> Ratio {
        self.seconds
    }
}

/// `value * factor / 2^32`.
#[inline(always)]
fn upper(value: i32, factor: i32) -> i32 {
    let half = (1_u32 << 31).wrapping_add((value >> 31) as u32);
    ((value as i64 * factor as i64 + half as i64) >> 32) as i32
}

impl<F: LeEqU32> TimeStep<FixedI32<F>> for Long<FixedI32<F>> {
    #[inline(always)]
    fn coef(&self) -> <FixedI32<F> as Scalar>::Coef {
        self.coef
    }

    #[inline(always)]
    fn times(&self, rate: FixedI32<F>) -> FixedI32<F> {
        FixedI32::from_bits(upper(rate.to_bits(), self.factor))
    }

    #[inline(always)]
    fn half_times(&self, rate: FixedI32<F>) -> FixedI32<F> {
        FixedI32::from_bits(upper(rate.to_bits(), self.half))
    }

    fn seconds(&self) -> Ratio {
        self.seconds
    }
}
