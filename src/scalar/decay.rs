//! Exponentials of a coefficient, for drags that are solved exactly.
//!
//! ```text
//! loss(x) = 1 - exp(-x) = x φ1       φ1 = (1 - exp(-x)) / x = 1 - x φ2       φ2 = (1 - φ1) / x
//! φ2(y)   = sum (-y)^n / (n + 2)!    for y <= 1/2
//! φ1(2y)  = φ1 (1 - loss/2)          φ2(2y) = φ2/2 + φ1²/4      loss(2y) = loss (2 - loss)
//! ```
//!
//! `x` is halved until it is at most 1/2, summed, and doubled as often: no division, no table. All numbers
//! lie between 0 and 1, in fixed point with two bits less than their storage. From x = 64 the remainder
//! is too small for a coefficient. The names are those of Hochbruck, Ostermann, "Exponential
//! integrators", Acta Numerica 19 (2010), section 2, with the opposite sign of x.

use fixed::types::extra::{LeEqU32, LeEqU64};
use fixed::{FixedI32, FixedI64};

use super::Scalar;
use super::factor::Coef;
use super::integer::Raw;

/// Doublings from which nothing is left of a velocity.
const ENOUGH: u32 = 7;

/// A number type in which drags can be solved exactly.
///
/// ```
/// use fixstep::Decay;
/// let [loss, mean, _] = f64::decay(1.0);
/// assert!((loss - (1.0 - (-1.0_f64).exp())).abs() < 1e-14);
/// assert!((mean - loss).abs() < 1e-14); // x = 1: both are 1 - exp(-1)
/// assert_eq!(f64::share(1.0), 0.5);
/// ```
pub trait Decay: Scalar {
    /// Three numbers for `x >= 0`, a rate times a time. The loss `1 - exp(-x)`, from 0 to 1.
    /// The mean of `exp(-x)` over the time, `(1 - exp(-x)) / x`. The mean loss over the time,
    /// divided by x: `(x - loss) / x²`.
    #[must_use]
    fn decay(x: Self::Coef) -> [Self::Coef; 3];

    /// `q / (1 + q)` for `q >= 0`, from 0 to 1. It is the loss by a drag that grows with the speed,
    /// and the share of one body in a pair.
    #[must_use]
    fn share(q: Self::Coef) -> Self::Coef;
}

/// `2^fraction / (n + 2)!`, rounded.
const fn inverse_factorial(n: u32, fraction: u32) -> u64 {
    let (mut product, mut k) = (1_u128, 2);
    while k <= n + 2 {
        product *= k as u128;
        k += 1;
    }
    ((1 << (fraction + 1)) / product).div_ceil(2) as u64
}

macro_rules! fixed_decay {
    ($fixed:ident<$bound:ident>, $raw:ident, $terms:literal) => {
        impl<F: $bound> Decay for $fixed<F> {
            fn decay(x: Coef<$raw>) -> [Coef<$raw>; 3] {
                const FRACTION: u32 = $raw::BITS - 2;
                const ONE: $raw = 1 << FRACTION;
                const TERMS: [$raw; $terms] = {
                    let (mut terms, mut n) = ([0; $terms], 0);
                    while n < $terms {
                        terms[n] = inverse_factorial(n as u32, FRACTION) as $raw;
                        n += 1;
                    }
                    terms
                };
                let times = |a: $raw, b: $raw| $raw::rounded(a.product(b), FRACTION);
                let of = |value| Coef::from_raw(value, FRACTION);
                let (mantissa, shift) = x.parts();
                // x < 2^above, so that this many halvings bring it to 1/2 or below.
                let above = $raw::BITS as i32 - mantissa.leading_zeros() as i32 - shift as i32;
                let doublings = (above + 1).max(0) as u32;
                if mantissa <= 0 {
                    return [of(0), of(ONE), of(ONE / 2)];
                }
                if doublings > ENOUGH {
                    let up = mantissa.leading_zeros() - 1;
                    let inverse = Coef::from_raw(mantissa << up, shift + up).inverse();
                    let remainder = ONE - inverse.scale(ONE);
                    return [of(ONE), inverse, inverse.times(of(remainder))];
                }
                let y = match (shift + doublings).checked_sub(FRACTION) {
                    None | Some(0) => mantissa << (FRACTION - shift - doublings),
                    Some(down) => $raw::rounded(mantissa.product(1), down),
                };
                let sum = |sum, &term: &$raw| term - times(y, sum);
                let mut mean_loss = TERMS.iter().rev().fold(0, sum);
                let mut mean = ONE - times(y, mean_loss);
                if doublings == 0 {
                    // The product keeps the digits of a small x.
                    return [x.times(of(mean)), of(mean), of(mean_loss)];
                }
                let mut loss = times(y, mean);
                for _ in 0..doublings {
                    mean_loss = mean_loss / 2 + times(mean, mean) / 4;
                    mean -= times(mean, loss / 2);
                    loss += times(loss, ONE - loss);
                }
                [of(loss), of(mean), of(mean_loss)]
            }

            // m / 2^k over 1 + m / 2^k, with all the digits that m has room for: quotient and divisor
            // are then within a unit of 2^-30. At most one, as the divisor is never less than half of m.
            fn share(q: Coef<$raw>) -> Coef<$raw> {
                const TOP: u32 = $raw::BITS - 2;
                let (mantissa, shift) = q.parts();
                if mantissa <= 0 {
                    return Coef::from_raw(0, 1);
                }
                let up = (mantissa.leading_zeros() - 1).min(2 * $raw::BITS - 2 - shift);
                let (mantissa, shift) = (mantissa << up, shift + up);
                match shift.checked_sub(TOP) {
                    None | Some(0) => {
                        let divisor = (mantissa >> 1) + ((1 << shift) >> 1);
                        let value = $raw::quotient(mantissa.product(1 << (TOP - 1)), divisor);
                        Coef::from_raw(value, TOP)
                    }
                    Some(down) => {
                        let divisor = (mantissa >> down.min($raw::BITS - 1)) + (1 << TOP);
                        let value = $raw::quotient(mantissa.product(1 << TOP), divisor);
                        Coef::from_raw(value, shift)
                    }
                }
            }
        }
    };
}

fixed_decay!(FixedI32<LeEqU32>, i32, 10);
fixed_decay!(FixedI64<LeEqU64>, i64, 17);

macro_rules! float_decay {
    ($float:ident, $terms:literal) => {
        impl Decay for $float {
            fn decay(x: $float) -> [$float; 3] {
                let (mut y, mut doublings) = (x, 0);
                while y > 0.5 && doublings <= ENOUGH {
                    (y, doublings) = (y * 0.5, doublings + 1);
                }
                if doublings > ENOUGH {
                    return [1.0, 1.0 / x, (1.0 - 1.0 / x) / x];
                }
                const TERMS: [$float; $terms] = {
                    let (mut terms, mut n) = ([0.0; $terms], 0);
                    while n < $terms {
                        let term = inverse_factorial(n as u32, 62) as $float;
                        terms[n] = term / (1_u64 << 62) as $float;
                        n += 1;
                    }
                    terms
                };
                let sum = |sum, &term: &$float| term - y * sum;
                let mut mean_loss = TERMS.iter().rev().fold(0.0, sum);
                let mut mean = 1.0 - y * mean_loss;
                let mut loss = y * mean;
                for _ in 0..doublings {
                    mean_loss = mean_loss * 0.5 + mean * mean * 0.25;
                    mean -= mean * loss * 0.5;
                    loss += loss * (1.0 - loss);
                }
                [loss, mean, mean_loss]
            }

            fn share(q: $float) -> $float {
                if q < 1.0 {
                    q / (1.0 + q)
                } else {
                    1.0 / (1.0 + 1.0 / q)
                }
            }
        }
    };
}

float_decay!(f32, 10);
float_decay!(f64, 17);
