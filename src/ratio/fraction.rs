//! Products, sums and quotients of ratios: exact where 62 bits suffice, else off by `2^-62` of themselves.
//!
//! For values computed once, at start-up, from numbers of any size. Uses integers only, mostly additions and
//! shifts. The functions are not inlined: here flash counts and time does not. A result from `2^62` is `None`;
//! one below `2^-62` is zero.

use crate::ratio::Ratio;

impl Ratio {
    /// `self * other`.
    #[inline(never)]
    pub(crate) fn times(self, other: Ratio) -> Option<Ratio> {
        let product = Ratio::scaled(self.size() * other.size(), wide(self) * wide(other), 0)?;
        product.signed(self.num() < 0, other.num() < 0)
    }

    /// `self / other`; `None` where that is zero.
    #[inline(never)]
    pub(crate) fn per(self, other: Ratio) -> Option<Ratio> {
        let quotient = Ratio::scaled(self.size() * wide(other), wide(self) * other.size(), 0)?;
        quotient.signed(self.num() < 0, other.num() < 0)
    }

    /// `self + other`, of either sign.
    #[inline(never)]
    pub(crate) fn and(self, other: Ratio) -> Option<Ratio> {
        let left = self.num() as i128 * other.den() as i128;
        let sum = left + other.num() as i128 * self.den() as i128;
        let magnitude = Ratio::scaled(sum.unsigned_abs(), wide(self) * wide(other), 0)?;
        magnitude.signed(sum < 0, false)
    }

    /// `self - other`.
    pub(crate) fn less(self, other: Ratio) -> Option<Ratio> {
        self.and(other.signed(true, false)?)
    }

    /// `self²`.
    pub(crate) fn square(self) -> Option<Ratio> {
        self.times(self)
    }

    /// `self`, negated by each of two signs that is set.
    pub(crate) fn signed(self, minus: bool, too: bool) -> Option<Ratio> {
        let num = if minus == too {
            self.num()
        } else {
            -self.num()
        };
        Ratio::new(num, self.den()).ok()
    }

    /// `num / den * 2^exponent`; both below `2^127`.
    #[inline(never)]
    pub(crate) fn scaled(num: u128, den: u128, exponent: i32) -> Option<Ratio> {
        if num == 0 || den == 0 {
            return (den != 0).then_some(Ratio::ZERO);
        }
        let exact = Ratio::exact(num, den, exponent);
        exact.or_else(|| Ratio::to_62_bits(num, den, exponent))
    }

    /// The same where 62 bits hold it; neither is zero.
    pub(crate) fn exact(num: u128, den: u128, exponent: i32) -> Option<Ratio> {
        let (twos, halves) = (num.trailing_zeros(), den.trailing_zeros());
        let (num, den) = (num >> twos, den >> halves);
        let exponent = exponent + twos as i32 - halves as i32;
        pair(num, den, exponent).or_else(|| {
            let divisor = common(num, den);
            pair(
                num.checked_div(divisor)?,
                den.checked_div(divisor)?,
                exponent,
            )
        })
    }

    /// The same to 62 bits, bit by bit; neither is zero.
    #[inline(never)]
    fn to_62_bits(num: u128, den: u128, exponent: i32) -> Option<Ratio> {
        let to_the_top = |value: u128| value.leading_zeros().saturating_sub(1);
        let (up, down) = (to_the_top(num), to_the_top(den));
        let (mut remainder, by) = (num << up, den << down);
        let mut whole = exponent + down as i32 - up as i32;
        if remainder < by {
            (remainder, whole) = (remainder << 1, whole - 1);
        }
        // The value is 1 to 2 times 2^whole. For a small value the denominator takes the 62 bits.
        if whole < 0 {
            let inverse = Ratio::to_62_bits(den, num, -exponent);
            return inverse.map_or(Some(Ratio::ZERO), Ratio::inverse);
        }
        let fraction = u32::try_from(61 - whole).ok()?;
        let mut value = 0;
        for _ in 0..62 {
            let bit = remainder >= by;
            remainder = (if bit { remainder - by } else { remainder }) << 1;
            value = value << 1 | i64::from(bit);
        }
        Ratio::new(value + i64::from(remainder >= by), 1 << fraction).ok()
    }

    fn size(self) -> u128 {
        self.num().unsigned_abs().into()
    }
}

fn wide(ratio: Ratio) -> u128 {
    ratio.den().into()
}

/// The fraction whose numerator or denominator takes the power of two.
#[inline(never)]
fn pair(num: u128, den: u128, exponent: i32) -> Option<Ratio> {
    let up = |value: u128, by: i32| {
        let fits = by < value.leading_zeros() as i32;
        fits.then(|| value << (by.max(0) as u32 & 127))
    };
    let (num, den) = (up(num, exponent)?, up(den, -exponent)?);
    Ratio::new(i64::try_from(num).ok()?, u64::try_from(den).ok()?).ok()
}

/// The greatest common divisor of odd numbers, without a division.
#[inline(never)]
fn common(mut a: u128, mut b: u128) -> u128 {
    while a != b {
        let (large, small) = (a.max(b), a.min(b));
        let remainder = large - small;
        (a, b) = (remainder >> remainder.trailing_zeros(), small);
    }
    a
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ratio(num: i64, den: u64) -> Ratio {
        Ratio::new(num, den).unwrap()
    }

    #[test]
    fn short_results_are_exact() {
        let (third, half) = (ratio(1, 3), ratio(-1, 2));
        assert_eq!(third.times(half), Some(ratio(-1, 6)));
        assert_eq!(third.and(half), Some(ratio(-1, 6)));
        assert_eq!(third.less(half), Some(ratio(5, 6)));
        assert_eq!(half.per(third), Some(ratio(-3, 2)));
        assert_eq!(half.square(), Some(ratio(1, 4)));
        assert_eq!(third.per(Ratio::ZERO), None);
        // Its own inverse: the product is one though the fractions are long.
        let long = ratio((1 << 61) - 1, (1 << 62) - 57);
        assert_eq!(long.times(long.inverse().unwrap()), Some(ratio(1, 1)));
        assert_eq!(Ratio::exact(3, 1, -62), Some(ratio(3, 1 << 62)));
        assert_eq!(Ratio::exact(3, 1, -63), None);
    }

    // Of 1/a and of a/b with primes of 61 and 62 bits, against whole numbers: |q - x| <= x / 2^62.
    #[test]
    fn long_results_are_off_by_two_to_the_minus_62() {
        let (a, b) = ((1_i64 << 61) - 1, (1_u64 << 62) - 57);
        for exponent in [-61, -40, -1, 0, 1, 40, 61] {
            let (num, den) = (a as u128 * 7, b as u128 * 5);
            let q = Ratio::to_62_bits(num, den, exponent).unwrap();
            // num / den 2^e = n / d: compared as n den / (d num 2^e) = 1.
            let scale = |value: u128, up: i32| value as f64 * 2.0_f64.powi(up);
            let coarse = scale(q.num() as u128, 0) / scale(q.den().into(), 0);
            let near = coarse / (num as f64 / den as f64 * 2.0_f64.powi(exponent)) - 1.0;
            assert!(near.abs() <= 1e-15, "{exponent}: {near:e}");
            let back = q.times(ratio(b as i64, a as u64)).unwrap();
            let (up, down) = (exponent.max(0), (-exponent).max(0));
            let off =
                back.num() as i128 * 5 * (1_i128 << down) - back.den() as i128 * 7 * (1_i128 << up);
            let unit = (back.den() as i128 * 7 * (1_i128 << up)) >> 62;
            assert!(off.abs() <= 3 * unit + 3, "{exponent}: {off} of {unit}");
        }
    }

    #[test]
    fn the_ends_are_zero_and_none() {
        let (small, large) = (ratio(1, 1 << 62), ratio(1 << 62, 1));
        assert_eq!(small.times(ratio(1, 3)), Some(Ratio::ZERO));
        assert_eq!(large.times(ratio(4, 3)), None);
        assert_eq!(large.and(large), None);
        assert_eq!(large.less(large), Some(Ratio::ZERO));
        assert_eq!(small.times(large), Some(ratio(1, 1)));
        assert_eq!(Ratio::scaled(1, 0, 0), None);
        assert_eq!(Ratio::scaled(1, 1, 1 << 20), None);
        assert_eq!(Ratio::scaled(1, 1, -(1 << 20)), Some(Ratio::ZERO));
    }
}
