//! `fixed`'s signed types of 32 bits, and those of 64 as a wide reference.
//!
//! Sums saturate, products go through [`Raw`] and its laws; of the crate `fixed` only the
//! representation and its saturating sums are used. A type needs at least one
//! fractional bit and one before the point: others do not compile.

use fixed::types::extra::{LeEqU32, LeEqU64};
use fixed::{FixedI32, FixedI64};

use super::Gain;
use super::factor::{Coef, InvMass, Span};
use super::integer::Raw;
use super::{Exact, Factor, Scalar};
use crate::ratio::Ratio;

macro_rules! factor {
    ($fixed:ident<$bound:ident>, $factor:ty) => {
        impl<F: $bound> Factor<$fixed<F>> for $factor {
            #[inline(always)]
            fn new(ratio: Ratio) -> Option<Self> {
                <$factor>::new(ratio)
            }

            #[inline]
            fn scale(self, value: $fixed<F>) -> $fixed<F> {
                $fixed::from_bits(self.scale(value.to_bits()))
            }

            fn to_f64(self) -> f64 {
                self.to_f64()
            }
        }
    };
}

macro_rules! fixed_scalar {
    ($fixed:ident<$bound:ident>, $raw:ident) => {
        factor!($fixed<$bound>, Coef<$raw>);
        factor!($fixed<$bound>, Span<$raw>);
        factor!($fixed<$bound>, InvMass<$raw>);

        impl<F: $bound> Exact for $fixed<F> {}

        impl<F: $bound> Scalar for $fixed<F> {
            type Coef = Coef<$raw>;
            type Span = Span<$raw>;
            type InvMass = InvMass<$raw>;
            type Sum = <$raw as Raw>::Wide;
            type Gain = Gain<$raw>;

            const ZERO: Self = {
                assert!(
                    F::U32 >= 1 && F::U32 < $raw::BITS,
                    "a fractional and an integer bit"
                );
                $fixed::ZERO
            };
            const MAX: Self = $fixed::MAX;
            const COEF_BITS: u32 = $raw::BITS - 2;

            #[inline(always)]
            fn spans(ratio: Ratio) -> Option<[Span<$raw>; 2]> {
                Span::around(ratio)
            }

            #[inline(always)]
            fn ratio(ratio: Ratio) -> Option<Self> {
                let magnitude = $raw::try_from(ratio.shifted(F::U32)?).ok()?;
                Some($fixed::from_bits(if ratio.num() < 0 {
                    -magnitude
                } else {
                    magnitude
                }))
            }

            #[inline]
            fn plus(self, other: Self) -> Self {
                self.saturating_add(other)
            }

            #[inline]
            fn minus(self, other: Self) -> Self {
                self.saturating_sub(other)
            }

            #[inline]
            fn negated(self) -> Self {
                self.saturating_neg()
            }

            #[inline]
            fn times(self, other: Self) -> Self {
                Self::narrow(self.to_bits().product(other.to_bits()))
            }

            #[inline(always)]
            fn dyadic(self, num: u32, shift: u32) -> Self {
                $fixed::from_bits(self.to_bits().dyadic(num, shift))
            }

            #[inline]
            fn gain(self, h: Coef<$raw>) -> Gain<$raw> {
                h.gain(self.to_bits())
            }

            #[inline]
            fn gained(gain: Gain<$raw>, tick: u64) -> Self {
                let (whole, rest) = gain.at(tick);
                $fixed::from_bits(whole).plus($fixed::from_bits(rest))
            }

            #[inline]
            fn dot(a: [Self; 2], b: [Self; 2]) -> Self::Sum {
                Raw::dot(a.map(Self::to_bits), b.map(Self::to_bits))
            }

            #[inline]
            fn narrow(sum: Self::Sum) -> Self {
                $fixed::from_bits(Raw::rounded(sum, F::U32))
            }

            fn quotient(sum: Self::Sum, divisor: Self) -> Self {
                $fixed::from_bits(Raw::short_quotient(sum, divisor.to_bits()))
            }

            fn length(v: [Self; 2]) -> Self {
                $fixed::from_bits(Raw::length(v.map(Self::to_bits)))
            }

            fn inverse_length(v: [Self; 2], softening: Self) -> Coef<$raw> {
                Coef::inverse_length(v.map(Self::to_bits), softening.to_bits(), F::U32)
            }

            #[inline]
            fn coef(self) -> Coef<$raw> {
                Coef::from_raw(self.to_bits(), F::U32)
            }

            #[inline]
            fn mass(inverse: InvMass<$raw>) -> Coef<$raw> {
                inverse.mass()
            }

            #[inline]
            fn product(a: Coef<$raw>, b: Coef<$raw>) -> Coef<$raw> {
                a.times(b)
            }

            // A loss of exactly nothing is no loss.
            #[inline]
            fn lost(self, loss: Coef<$raw>) -> Self {
                let lost = Factor::<Self>::scale(loss, self);
                if lost == Self::ZERO && !loss.is_zero() {
                    return $fixed::from_bits(self.to_bits().signum());
                }
                lost
            }

            #[inline]
            fn is_inside(self) -> bool {
                self.to_bits().unsigned_abs() < $raw::MAX.unsigned_abs()
            }

            #[inline]
            fn bits(self) -> u64 {
                self.to_bits() as u64
            }

            fn to_f64(self) -> f64 {
                self.to_bits() as f64 / (1_u64 << F::U32) as f64
            }
        }
    };
}

fixed_scalar!(FixedI32<LeEqU32>, i32);
fixed_scalar!(FixedI64<LeEqU64>, i64);
