//! Exponentials to 126 bits, by another way than the crate's: a Taylor series for the fraction of x
//! and powers of `1/e` for its whole part. All errors are below `2^-118`.

use fixstep::fixed::types::{I2F62, I8F24, I16F16, I16F48, I32F32};
use fixstep::scalar::Factor;
use fixstep::{Decay, Ratio, Scalar};

use crate::support::Format;

/// One.
pub const ONE: u128 = 1 << 126;

/// `a b` of numbers up to 1, by schoolbook.
fn times(a: u128, b: u128) -> u128 {
    const LOW: u128 = u64::MAX as u128;
    let (a1, a0, b1, b0) = (a >> 64, a & LOW, b >> 64, b & LOW);
    let (low, one, two) = (a0 * b0, a1 * b0, a0 * b1);
    let middle = (low >> 64) + (one & LOW) + (two & LOW);
    let high = a1 * b1 + (one >> 64) + (two >> 64) + (middle >> 64);
    high << 2 | (middle & LOW) >> 62
}

/// `[loss, φ1, φ2]` of y up to 1.
fn series(y: u128) -> [u128; 3] {
    let rest = (3..48).rev().fold(ONE, |sum, n| ONE - times(y, sum) / n);
    let mean = ONE - times(y, rest / 2);
    [times(y, mean), mean, rest / 2]
}

/// `a / x` for `x = m / 2^k` from 1 on.
fn over(a: u128, m: u64, k: u32) -> u128 {
    let m = u128::from(m);
    ((a / m) << k) + ((a % m) << k) / m
}

/// `[1 - exp(-x), (1 - exp(-x))/x, (x - 1 + exp(-x))/x²]` for `x = m / 2^k`, m above zero.
pub fn decay(m: u64, k: u32) -> [u128; 3] {
    let whole = m.checked_shr(k).unwrap_or(0);
    if whole == 0 {
        return series(u128::from(m) << (126 - k));
    }
    let fraction = u128::from(m - (whole << k)) << (126 - k);
    let part = ONE - series(fraction)[0];
    let inverse = ONE - series(ONE)[0];
    let left = (0..whole.min(128)).fold(part, |left, _| times(left, inverse));
    let mean = over(ONE - left, m, k);
    [ONE - left, mean, over(ONE - mean, m, k)]
}

/// `q / (1 + q)` for `q = m / 2^k`, bit by bit.
pub fn share(m: u64, k: u32) -> u128 {
    let (mut rest, divisor) = (u128::from(m), (1_u128 << k) + u128::from(m));
    (0..126).fold(0, |quotient, _| {
        rest <<= 1;
        let bit = u128::from(rest >= divisor);
        rest -= bit * divisor;
        quotient << 1 | bit
    })
}

/// A scalar whose coefficients a test can make and read bit by bit.
pub trait Bits: Format + Decay {
    /// Bits of a mantissa, and the last place that a coefficient can have. A ratio has 62 bits.
    const MANTISSA: u32;
    const LAST: u32;
    /// What 1 rounds by: one unit of a fraction, or half a unit of a float.
    const ROUNDING: f64;

    /// A coefficient of at most 1 in units of `2^-126`, to a rounding.
    fn read(coef: Self::Coef) -> u128 {
        (Factor::<Self>::to_f64(coef) * ONE as f64) as u128
    }

    /// `m / 2^k`, exactly: a number from 1/2 to 1 by powers of two.
    fn make(m: u64, k: u32) -> Self::Coef {
        let of = |num, den| Self::Coef::new(Ratio::new(num, den).unwrap()).unwrap();
        let bits = u64::BITS - m.leading_zeros();
        let (mut coef, mut down) = (of(m as i64, 1 << bits), k as i32 - bits as i32);
        while down != 0 {
            let by = down.clamp(-20, 30);
            let power = match u32::try_from(by) {
                Ok(by) => of(1, 1 << by),
                Err(_) => of(1 << -by, 1),
            };
            (coef, down) = (Self::product(coef, power), down - by);
        }
        coef
    }
}

macro_rules! bits {
    ($($scalar:ty, $mantissa:literal, $last:literal, $rounding:literal;)*) => {
        $(impl Bits for $scalar {
            const MANTISSA: u32 = $mantissa;
            const LAST: u32 = $last;
            const ROUNDING: f64 = 1.0 / (1_u64 << $rounding) as f64;
        })*
    };
}

bits! {
    f32, 24, 110, 24;
    f64, 53, 110, 53;
    I16F16, 31, 62, 30;
    I8F24, 31, 62, 30;
}

// `to_f64` has too few bits: the coefficient times a power of two that leads near 1, times 1.
macro_rules! long_bits {
    ($($scalar:ty),*) => {
        $(impl Bits for $scalar {
            const MANTISSA: u32 = 62;
            const LAST: u32 = 110;
            const ROUNDING: f64 = 1.0 / (1_u64 << 62) as f64;

            fn read(coef: Self::Coef) -> u128 {
                let value = Factor::<Self>::to_f64(coef);
                if value == 0.0 {
                    return 0;
                }
                let up = (-value.log2()).floor().max(0.0) as u32;
                let power = Ratio::new(1 << up, 1).unwrap();
                let near = Self::product(coef, <Self::Coef as Factor<Self>>::new(power).unwrap());
                let bits = Factor::<I2F62>::scale(near, I2F62::from_bits(1 << 62)).to_bits();
                (bits as u128) << 64 >> up
            }
        })*
    };
}

long_bits!(I32F32, I16F48);
