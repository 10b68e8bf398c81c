//! What a constant rate adds in one step. Its fraction is spread over the ticks.

use super::factor::Coef;
use super::integer::Raw;

/// What a constant rate adds in one step: `whole + unit * fraction / 2^32`.
///
/// ```
/// use fixstep::{Scalar, dec, fixed::types::I16F16, scalar::{Coef, Factor}};
/// let h: Coef<i32> = Factor::<I16F16>::new(dec!(0.1)).unwrap();
/// let gain = I16F16::lit("1").gain(h);
/// let sum = (0..10).fold(I16F16::ZERO, |v, tick| v.plus(I16F16::gained(gain, tick)));
/// assert_eq!(sum, 1); // ten rounded steps of 0.1 would sum to 1.00006
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Gain<R> {
    whole: R,
    unit: R,
    fraction: u32,
}

impl<R: Raw> Gain<R> {
    /// The whole part, and the unit or zero: a unit falls due where `fraction * t + 1/2` passes a
    /// whole number between `t = tick` and `tick + 1`, the carry of a counter that may wrap.
    #[inline]
    pub(super) fn at(self, tick: u64) -> (R, R) {
        let phase = self
            .fraction
            .wrapping_mul(tick as u32)
            .wrapping_add(1 << 31);
        let due = phase.overflowing_add(self.fraction).1;
        (
            self.whole,
            if due { self.unit } else { R::signed(0, false) },
        )
    }
}

impl<R: Raw> Coef<R> {
    /// `self * value` with 32 bits of fraction, towards zero.
    #[inline]
    pub(super) fn gain(self, value: R) -> Gain<R> {
        let (mantissa, shift) = self.parts();
        let (whole, unit, fraction) = R::split(value.product(mantissa), shift);
        Gain {
            whole,
            unit,
            fraction,
        }
    }
}
