//! Scalars as exact fractions: each is a whole number times a power of two.
//!
//! For values computed at start-up in integers. It does no float arithmetic: it reads the sign,
//! exponent and fraction of a float from its bits.

use fixed::types::extra::{LeEqU32, LeEqU64};
use fixed::{FixedI32, FixedI64};

use super::Scalar;
use crate::ratio::Ratio;

/// A number type whose numbers are fractions. [Shapes](crate::mass) accept every type that implements it.
///
/// ```
/// use fixstep::{dec, fixed::types::I16F16, Rational};
/// assert_eq!(I16F16::lit("-2.25").rational(), Some(dec!(-2.25)));
/// assert_eq!(0.375_f32.rational(), Some(dec!(0.375)));
/// assert_eq!(f32::INFINITY.rational(), None);
/// ```
pub trait Rational: Scalar {
    /// `(m, e)` with `self = m * 2^e`, exactly; `None` for NaN and infinity.
    #[must_use]
    fn binary(self) -> Option<(i64, i32)>;

    /// The same number as a fraction, exactly; `None` for NaN, infinity, and what 62 bits cannot
    /// hold.
    #[must_use]
    fn rational(self) -> Option<Ratio> {
        match self.binary()? {
            (0, _) => Some(Ratio::ZERO),
            (mantissa, exponent) => {
                let magnitude = Ratio::exact(mantissa.unsigned_abs().into(), 1, exponent)?;
                magnitude.signed(mantissa < 0, false)
            }
        }
    }
}

macro_rules! fixed_rational {
    ($fixed:ident<$bound:ident>) => {
        impl<F: $bound> Rational for $fixed<F> {
            #[inline]
            fn binary(self) -> Option<(i64, i32)> {
                Some((self.to_bits().into(), -F::I32))
            }
        }
    };
}

fixed_rational!(FixedI32<LeEqU32>);
fixed_rational!(FixedI64<LeEqU64>);

macro_rules! float_rational {
    ($float:ident, $fraction:literal) => {
        impl Rational for $float {
            // A subnormal has the exponent of the smallest normal number and no hidden bit.
            #[inline]
            fn binary(self) -> Option<(i64, i32)> {
                const BIAS: i32 = $float::MAX_EXP - 1 + $fraction;
                const BEYOND: i32 = 2 * $float::MAX_EXP - 1;
                let bits = self.to_bits();
                let exponent = (bits << 1 >> ($fraction + 1)) as i32;
                let hidden = ((exponent > 0) as i64) << $fraction;
                let magnitude = hidden | (bits & ((1 << $fraction) - 1)) as i64;
                let mantissa = match self.is_sign_negative() {
                    true => -magnitude,
                    false => magnitude,
                };
                (exponent != BEYOND).then_some((mantissa, exponent.max(1) - BIAS))
            }
        }
    };
}

float_rational!(f32, 23);
float_rational!(f64, 52);

#[cfg(test)]
mod tests {
    use super::*;
    use fixed::types::{I1F31, I8F24, I32F32};

    fn ratio(num: i64, den: u64) -> Option<Ratio> {
        Ratio::new(num, den).ok()
    }

    #[test]
    fn fixed_point_is_its_bits() {
        assert_eq!(I8F24::from_bits(-5).rational(), ratio(-5, 1 << 24));
        assert_eq!(I8F24::MIN.rational(), ratio(-128, 1));
        assert_eq!(I1F31::MIN.binary(), Some((-(1 << 31), -31)));
        assert_eq!(I32F32::DELTA.rational(), ratio(1, 1 << 32));
        assert_eq!(I32F32::MIN.rational(), ratio(-(1 << 31), 1));
        // 63 odd bits are one too many.
        assert_eq!(I32F32::MAX.rational(), None);
        assert_eq!(I32F32::MAX.binary(), Some((i64::MAX, -32)));
    }

    #[test]
    fn floats_are_taken_apart() {
        assert_eq!((-0.1_f32).rational(), ratio(-13_421_773, 1 << 27));
        let tenth = 3_602_879_701_896_397;
        assert_eq!(0.1_f64.rational(), ratio(tenth, 1 << 55));
        assert_eq!((-0.0_f32).rational(), Some(Ratio::ZERO));
        assert_eq!(1e18_f64.rational(), ratio(1_000_000_000_000_000_000, 1));
        for bad in [f64::NAN, -f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!((bad.binary(), (bad as f32).binary()), (None, None));
        }
        assert_eq!(f32::from_bits(1).binary(), Some((1, -149)));
        assert_eq!(f64::MIN_POSITIVE.binary(), Some((1 << 52, -1074)));
        assert_eq!(f32::MAX.binary(), Some(((1 << 24) - 1, 104)));
        assert_eq!(
            (f32::MAX.rational(), f64::from_bits(1).rational()),
            (None, None)
        );
    }
}
