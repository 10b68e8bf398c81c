//! Constants as ratios of integers. Making one needs no floating-point code.
//!
//! A [`Ratio`] is exact. A constructor rounds it once into the number type. For a ratio written in
//! the source, the compiler computes the rounded constant. A ratio known only at run time costs a
//! 128-bit division.
//!
//! ```
//! use fixstep::{Scalar, dec, fixed::types::I16F16};
//! assert_eq!(I16F16::ratio(dec!(0.1)), Some(I16F16::lit("0.1")));
//! ```

mod decimal;
mod error;
mod fraction;
mod rounding;

use core::fmt;
use core::num::NonZero;

pub use error::RatioError;

/// An exact fraction `num / den`, `den > 0`; magnitudes up to `2^62`.
///
/// ```
/// use fixstep::{dec, Ratio};
/// assert_eq!(dec!(-9.81), Ratio::new(-981, 100).unwrap());
/// assert!(Ratio::new(1, 0).is_err());
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Ratio {
    num: i64,
    den: u64,
}

/// Largest numerator and denominator: leaves room to round and to halve.
const LIMIT: u64 = 1 << 62;

impl Ratio {
    /// Zero.
    pub const ZERO: Ratio = Ratio { num: 0, den: 1 };

    /// `num / den` to 62 bits; `None` where it is too large or has no denominator.
    pub(crate) fn nearest(num: u128, den: u128) -> Option<Ratio> {
        let excess = 66_u32.saturating_sub((num | den).leading_zeros());
        let (num, den) = (num >> excess, den >> excess);
        Ratio::new(num as i64, den as u64).ok()
    }

    /// `num / den`, exact where 62 bits suffice, else to `2^-61` of the larger of itself and 1;
    /// `den < 2^64`.
    pub(crate) fn quotient(num: u128, den: u128) -> Option<Ratio> {
        if (num | den).leading_zeros() >= 66 {
            return Ratio::new(num as i64, den as u64).ok();
        }
        let by = NonZero::new(den)?;
        let (whole, remainder) = (num / by, num % by);
        let shift = (whole | 1).leading_zeros().checked_sub(66)?.min(62);
        let value = (whole << shift) + (remainder << shift) / by;
        Ratio::new(value as i64, 1 << shift).ok()
    }

    /// `num / den` in lowest terms; `None` where that takes more than 62 bits.
    pub(crate) fn reduced(num: u128, den: u128) -> Option<Ratio> {
        let (mut divisor, mut remainder) = (num, den);
        while let Some(by) = NonZero::new(remainder) {
            (divisor, remainder) = (by.get(), divisor % by);
        }
        let divisor = NonZero::new(divisor)?;
        let num = i64::try_from(num / divisor).ok()?;
        Ratio::new(num, u64::try_from(den / divisor).ok()?).ok()
    }

    /// `self + other` of ratios greater than zero, reduced, to within `2^-32` of itself.
    pub(crate) fn plus(self, other: Ratio) -> Option<Ratio> {
        let left = self.num as u128 * other.den as u128;
        let right = other.num as u128 * self.den as u128;
        let (num, den) = (left + right, self.den as u128 * other.den as u128);
        Ratio::reduced(num, den).or_else(|| {
            Ratio::nearest(num, den).filter(|sum| sum.den >> 33 != 0 && sum.num >> 33 != 0)
        })
    }

    /// `self / other` of ratios greater than zero, to 62 bits.
    pub(crate) fn over(self, other: Ratio) -> Option<Ratio> {
        let num = self.num as u128 * other.den as u128;
        Ratio::nearest(num, self.den as u128 * other.num as u128)
    }

    /// A whole number.
    pub(crate) const fn whole(num: u32) -> Ratio {
        Ratio {
            num: num as i64,
            den: 1,
        }
    }

    /// `num / den` of numbers up to `2^62`.
    pub(crate) fn fraction(num: u64, den: NonZero<u64>) -> Ratio {
        Ratio {
            num: num as i64,
            den: den.get(),
        }
    }

    /// `num / den`. Refuses `den == 0` and magnitudes above `2^62`.
    pub const fn new(num: i64, den: u64) -> Result<Ratio, RatioError> {
        if den == 0 || den > LIMIT || num.unsigned_abs() > LIMIT {
            return Err(RatioError::NotANumber { field: "ratio" });
        }
        Ok(Ratio { num, den })
    }

    /// `self / 2` of a ratio greater than zero.
    pub(crate) fn halved(self) -> Option<Ratio> {
        match self.num % 2 {
            0 => Ratio::new(self.num / 2, self.den).ok(),
            _ => {
                Ratio::nearest(self.num as u128, 2 * self.den as u128).filter(|half| half.num != 0)
            }
        }
    }

    /// `1 / self` of a ratio greater than zero.
    #[inline]
    pub(crate) const fn inverse(self) -> Option<Ratio> {
        if self.num <= 0 {
            return None;
        }
        Some(Ratio {
            num: self.den as i64,
            den: self.num as u64,
        })
    }

    /// Numerator, with the sign.
    #[must_use]
    pub const fn num(self) -> i64 {
        self.num
    }

    /// Denominator, greater than zero.
    #[must_use]
    pub const fn den(self) -> u64 {
        self.den
    }

    /// The ratio equal to `value`: exact where 62 bits suffice, else the nearest.
    /// For code on a host; on a device use [`dec!`](crate::dec). Refuses NaN and magnitudes from `2^62`.
    pub fn from_f64(value: f64) -> Result<Ratio, RatioError> {
        let magnitude = libm::fabs(value);
        if magnitude.is_nan() || magnitude >= LIMIT as f64 {
            return Err(RatioError::NotFinite { field: "value" });
        }
        let (mut num, mut den) = (magnitude, 1_u64);
        while num < (1_u64 << 52) as f64 && den < LIMIT && libm::trunc(num) != num {
            (num, den) = (num * 2.0, den * 2);
        }
        let num = libm::round(num) as i64;
        Ratio::new(if value < 0.0 { -num } else { num }, den)
    }

    /// The nearest `f64`, for reports and references.
    #[must_use]
    pub fn to_f64(self) -> f64 {
        self.num as f64 / self.den as f64
    }
}

/// Compares values: 1/2 equals 2/4.
impl PartialEq for Ratio {
    fn eq(&self, other: &Ratio) -> bool {
        self.num as i128 * other.den as i128 == other.num as i128 * self.den as i128
    }
}

impl Eq for Ratio {}

impl From<i32> for Ratio {
    #[inline]
    fn from(whole: i32) -> Ratio {
        Ratio {
            num: whole as i64,
            den: 1,
        }
    }
}

impl fmt::Display for Ratio {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.den {
            1 => write!(f, "{}", self.num),
            den => write!(f, "{}/{}", self.num, den),
        }
    }
}
