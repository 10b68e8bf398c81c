//! The three factors of fixed point, each with its own position of the binary point.
//!
//! ```text
//! Coef     m / 2^k               m of 31 bits         any k: exact for powers of two
//! Span     m / 2^(BITS + s)      m of 31 bits, odd    high word, add, shift: the hot loop
//! InvMass  32 m / 2^(20 + e)     m of 26 bits         packed in the 4 bytes a body has for it
//! ```
//!
//! Why a span is odd: `v m` lies on a tie where it is `2^(31+s)` modulo `2^(32+s)`. With m odd,
//! v itself would have to be a multiple of `2^(31+s)`; for `s >= 1` no 32-bit v but zero is. So
//! rounding half up is symmetric at no cost. The price is that `h` may be off by a unit or two of its
//! mantissa, 9.4e-10 each; a length that is a power of two can be had exactly in
//! [`DyadicStep`](crate::DyadicStep).
//!
//! Why spans come in pairs: at 1/60 s every sixtieth velocity has `h v` half-way between two
//! positions. One span sends all of them outwards, or all inwards; a spring of 1 Hz then runs
//! `1/120` LSB a step ahead, 8 cm in 10^6 steps of an `I16F16`. Used alternately, one below and one
//! above `h`, they cancel. The mean of the two is within one unit of `h`.

use super::integer::Raw;
use crate::ratio::Ratio;

/// A coefficient `m / 2^k`, for a scalar stored in `R`.
///
/// ```
/// use fixstep::{dec, fixed::types::I16F16, scalar::{Coef, Factor}};
/// let drag: Coef<i32> = Factor::<I16F16>::new(dec!(0.25)).unwrap();
/// assert_eq!(drag.scale(I16F16::lit("6")), 1.5);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Coef<R> {
    mantissa: R,
    shift: u32,
}

/// A *span* is a length of time below a quarter second, for a scalar stored in `R`.
///
/// ```
/// use fixstep::{dec, fixed::types::I16F16, scalar::{Factor, Span}};
/// let h: Span<i32> = Factor::<I16F16>::new(dec!(0.1)).unwrap();
/// assert_eq!(h.scale(I16F16::lit("1")), I16F16::lit("0.1"));
/// assert_eq!(<Span<i32> as Factor<I16F16>>::new(dec!(0.25)), None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Span<R> {
    mantissa: R,
    shift: u32,
}

/// One divided by a mass, packed in one `R`. In 32 bits the mass is between `2^-11` and `2^21` kg.
///
/// ```
/// use fixstep::{Scalar, dec, fixed::types::I16F16, scalar::{Factor, InvMass}};
/// let inverse: InvMass<i32> = Factor::<I16F16>::new(dec!(0.25)).unwrap();
/// assert_eq!(inverse.scale(I16F16::lit("8")), 2); // 8 N s change 4 kg by 2 m/s
/// assert_eq!(I16F16::mass(inverse).scale(I16F16::lit("1")), 4);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct InvMass<R>(pub(super) R);

impl<R: Raw> Coef<R> {
    pub(super) const MAX_SHIFT: u32 = 2 * R::BITS - 2;

    #[inline(always)]
    pub(super) fn new(ratio: Ratio) -> Option<Coef<R>> {
        let (mantissa, exponent) = ratio.mantissa(R::BITS - 1);
        let shift = match mantissa {
            0 => 1,
            _ => u32::try_from(-exponent).ok()?,
        };
        let mantissa = R::signed(mantissa, ratio.num() < 0);
        (1..=Self::MAX_SHIFT)
            .contains(&shift)
            .then_some(Coef { mantissa, shift })
    }

    /// `value / 2^shift`; the shift lies within the range of a coefficient's.
    #[inline]
    pub(super) const fn from_raw(value: R, shift: u32) -> Coef<R> {
        Coef {
            mantissa: value,
            shift,
        }
    }

    /// `1 / sqrt(x² + y² + s²)` of values with `fraction` fractional bits; zero for zero, and as
    /// large as a coefficient can be where it would be larger.
    #[inline]
    pub(super) fn inverse_length(v: [R; 2], s: R, fraction: u32) -> Coef<R> {
        let (mantissa, up) = R::inverse_length(v, s);
        match (2 * R::BITS - 2).checked_sub(up + fraction) {
            None | Some(0) => Coef {
                mantissa: mantissa.limit(),
                shift: 1,
            },
            Some(shift) => Coef { mantissa, shift },
        }
    }

    /// Mantissa and shift.
    #[inline]
    pub(super) fn parts(self) -> (R, u32) {
        (self.mantissa, self.shift)
    }

    /// `1 / self` of a mantissa without leading zeros, where a coefficient can hold it.
    #[inline]
    pub(super) fn inverse(self) -> Coef<R> {
        let shift = (2 * R::BITS - 4).saturating_sub(self.shift).max(1);
        Coef {
            mantissa: self.mantissa.reciprocal(),
            shift,
        }
    }

    #[inline]
    pub(super) fn is_zero(self) -> bool {
        self.mantissa == R::signed(0, false)
    }

    // Not `#[inline]`, like some others: one shared copy is smaller.
    pub(super) fn scale(self, value: R) -> R {
        R::rounded(value.product(self.mantissa), self.shift)
    }

    /// The product; it saturates above and loses bits below the range of a coefficient.
    pub(super) fn times(self, other: Coef<R>) -> Coef<R> {
        let (mantissa, up) = R::renormalised(self.mantissa.product(other.mantissa));
        let shift = self.shift + other.shift;
        if shift <= up {
            return Coef {
                mantissa: mantissa.limit(),
                shift: 1,
            };
        }
        match (shift - up).checked_sub(Self::MAX_SHIFT) {
            None | Some(0) => Coef {
                mantissa,
                shift: shift - up,
            },
            Some(excess) => {
                let shift = excess.min(R::BITS);
                Coef {
                    mantissa: Coef { mantissa, shift }.scale(R::signed(1, false)),
                    shift: Self::MAX_SHIFT,
                }
            }
        }
    }

    pub(super) fn to_f64(self) -> f64 {
        self.mantissa.to_f64() / (1_u128 << self.shift) as f64
    }
}

impl<R: Raw> Span<R> {
    #[inline(always)]
    pub(super) fn new(ratio: Ratio) -> Option<Span<R>> {
        let (magnitude, exponent) = ratio.floor_mantissa(R::BITS - 1);
        Self::from_odd(magnitude | 1, exponent, ratio)
    }

    /// The odd mantissas on either side. At the top of a power of two there may be but one.
    #[inline(always)]
    pub(super) fn around(ratio: Ratio) -> Option<[Span<R>; 2]> {
        let (magnitude, exponent) = ratio.floor_mantissa(R::BITS - 1);
        let below = magnitude.saturating_sub(1) | 1;
        let above = if (below + 2) >> (R::BITS - 1) == 0 {
            below + 2
        } else {
            below
        };
        let of = |odd| Self::from_odd(odd, exponent, ratio);
        Some([of(below)?, of(above)?])
    }

    #[inline(always)]
    fn from_odd(odd: u64, exponent: i32, ratio: Ratio) -> Option<Span<R>> {
        let mantissa = R::signed(odd, ratio.num() < 0);
        let shift = u32::try_from(-exponent).ok()?.checked_sub(R::BITS)?;
        (ratio.num() != 0 && (1..R::BITS).contains(&shift)).then_some(Span { mantissa, shift })
    }

    #[inline]
    pub(super) fn scale(self, value: R) -> R {
        value.high_product(self.mantissa).half_up(self.shift)
    }

    pub(super) fn to_f64(self) -> f64 {
        let scale = (1_u128 << self.shift) as f64 * (1_u128 << R::BITS) as f64;
        self.mantissa.to_f64() / scale
    }
}

impl<R: Raw> InvMass<R> {
    /// Where the mantissa's point lies for `e = 0`: a mass of 1 kg has `e = 10`.
    const BASE: u32 = R::BITS - 12;

    #[inline(always)]
    pub(super) fn new(ratio: Ratio) -> Option<InvMass<R>> {
        let (mantissa, exponent) = ratio.mantissa(R::BITS - 6);
        let shift = u32::try_from(5 - exponent).ok()?.checked_sub(Self::BASE)?;
        (ratio.num() > 0 && shift < 32)
            .then(|| InvMass(R::signed(mantissa << 5 | shift as u64, false)))
    }

    pub(super) fn scale(self, value: R) -> R {
        Coef::from(self).scale(value)
    }

    /// `1 / self`: exact for powers of two.
    #[inline]
    pub(super) fn mass(self) -> Coef<R> {
        let (mantissa, shift) = self.0.unpacked();
        Coef {
            mantissa: mantissa.reciprocal(),
            shift: 2 * R::BITS - 4 - Self::BASE - shift,
        }
    }

    pub(super) fn to_f64(self) -> f64 {
        let (mantissa, shift) = self.0.unpacked();
        mantissa.to_f64() / (1_u128 << (Self::BASE + shift)) as f64
    }
}

/// The same number: a packed mantissa is a mantissa with five bits to spare.
impl<R: Raw> From<InvMass<R>> for Coef<R> {
    #[inline]
    fn from(inverse: InvMass<R>) -> Coef<R> {
        let (mantissa, shift) = inverse.0.unpacked();
        Coef {
            mantissa,
            shift: InvMass::<R>::BASE + shift,
        }
    }
}
