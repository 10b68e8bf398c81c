//! What roundings leave over, kept: for a body that loses nothing to them.
//!
//! ```text
//! fixed point, 32 bits   position with 32 more fractional bits, velocity with 15 more
//! f32, f64               what the last sum lost, to be added to the next (Kahan)
//! ```
//!
//! **Momentum.** In fixed point a velocity with its remainder stands for a whole number of units of
//! momentum, `p(u) = round(u m)` with m scaled to between half a unit and a whole one, so that each
//! number p has a velocity u. An impulse adds a whole number of those units; the velocity becomes one
//! that stands for the sum. What one body gains the other loses, to the bit, for ever.
//! Source of the floats' sum: Kahan, "Further remarks on reducing truncation errors", Comm. ACM 8
//! (1965).

use fixed::FixedI32;
use fixed::types::extra::LeEqU32;

use super::Scalar;
use super::factor::{Coef, InvMass};
use super::high_product::product_i32;
use super::raw::Raw;

/// A number type whose roundings can be kept.
pub trait Carry: Scalar {
    /// A position with what moves left over.
    type Place: Copy + core::fmt::Debug + PartialEq + 'static;

    /// What kicks left over of a velocity.
    type Rest: Copy + core::fmt::Debug + PartialEq + 'static;

    /// Nothing left over.
    const NO_REST: Self::Rest;

    /// Bytes of a remainder in a snapshot.
    const REST_BYTES: usize;

    /// A position with nothing left over.
    #[must_use]
    fn place(self) -> Self::Place;

    /// The position nearest to a place.
    #[must_use]
    fn seen(place: Self::Place) -> Self;

    /// `place + factor * value / 2^halvings`, saturating; `halvings` is 0 or 1.
    #[must_use]
    fn moved(place: Self::Place, value: Self, factor: Self::Coef, halvings: u32) -> Self::Place;

    /// `place + num / 2^shift * value`, exact in fixed point; called with constants.
    #[must_use]
    fn moved_dyadic(place: Self::Place, value: Self, num: u32, shift: u32) -> Self::Place;

    /// A velocity and its remainder after `+ factor * value`.
    #[must_use]
    fn kicked(kept: (Self, Self::Rest), value: Self, factor: Self::Coef) -> (Self, Self::Rest);

    /// The same after losing `loss` of both.
    #[must_use]
    fn damped(kept: (Self, Self::Rest), loss: Self::Coef) -> (Self, Self::Rest);

    /// The same after `+ impulse / m`.
    #[must_use]
    fn pushed(
        kept: (Self, Self::Rest),
        impulse: Self,
        inv_mass: Self::InvMass,
    ) -> (Self, Self::Rest);

    /// Its momentum, remainder and all; exact in fixed point.
    #[must_use]
    fn momentum(kept: (Self, Self::Rest), inv_mass: Self::InvMass) -> f64;

    /// What a place holds beyond the position that is seen, for a hash: equal for equal places.
    #[must_use]
    fn left_over(place: Self::Place) -> u64;

    /// The bits of a place in two halves of a scalar's size, and back.
    #[must_use]
    fn halves(place: Self::Place) -> [u64; 2];

    /// The place of those halves.
    #[must_use]
    fn of_halves(halves: [u64; 2]) -> Option<Self::Place>;

    /// The bits of a remainder.
    #[must_use]
    fn rest_bits(rest: Self::Rest) -> u64;

    /// The remainder of those bits; `None` where no remainder has them.
    #[must_use]
    fn of_rest_bits(bits: u64) -> Option<Self::Rest>;
}

/// Fractional bits of a remainder: 15, so that ±1/2 and all between fit 16 bits.
const FINE: u32 = 15;

/// `wide / 2^shift`, nearest, ties away from zero; `shift >= 1`.
#[inline]
fn rounded(wide: i64, shift: u32) -> i64 {
    let half = 1 << (shift.wrapping_sub(1) & 63);
    wide.saturating_add(half).wrapping_add(wide >> 63) >> (shift & 63)
}

/// `value * mantissa / 2^shift` in units of `2^-fraction`, saturating.
#[inline]
fn scaled(value: i32, mantissa: i32, shift: u32, fraction: u32) -> i64 {
    let product = value as i64 * mantissa as i64;
    match shift.checked_sub(fraction) {
        None | Some(0) => product.saturating_mul(1 << (fraction - shift)),
        Some(down) => rounded(product, down),
    }
}

/// `place + change` for a change that leaves its upper word room for one more. The upper word
/// saturates alone: there the lower one no longer matters.
#[inline]
fn advanced(place: i64, change: i64) -> i64 {
    let (low, carry) = (place as u32).overflowing_add(change as u32);
    let more = ((change >> 32) as i32).wrapping_add(carry as i32);
    let high = ((place >> 32) as i32).saturating_add(more);
    (high as i64) << 32 | low as i64
}

/// A velocity in units of `2^-15` and back, the remainder at most half a unit of the type.
#[inline]
fn fine(value: i32, rest: i16) -> i64 {
    ((value as i64) << FINE) + rest as i64
}

/// The largest fine velocity.
const LIMIT: i64 = (i32::MAX as i64) << FINE;

#[inline]
fn kept(fine: i64) -> (i32, i16) {
    let fine = fine.clamp(-LIMIT, LIMIT);
    let value = rounded(fine, FINE);
    (value as i32, (fine - (value << FINE)) as i16)
}

/// Units of momentum that a fine velocity stands for: `|fine| mass / 2^30` with a mass from `2^29`
/// to `2^30`, rounded; odd.
#[inline]
fn units(fine: i64, mass: i32) -> i64 {
    let (mass, magnitude) = (mass as u64, fine.unsigned_abs());
    let (whole, part) = (magnitude >> FINE, magnitude & ((1 << FINE) - 1));
    let low = (part * mass + (1 << (2 * FINE - 1))) >> FINE;
    let units = ((whole * mass + low) >> FINE) as i64;
    if fine < 0 { -units } else { units }
}

/// A mass of `mantissa / 2^shift` counts momentum in units of `2^(FINE - shift)` of the type's.
#[inline]
fn exchange(impulse: i32, shift: u32) -> i64 {
    match shift.checked_sub(FINE) {
        Some(up) => (impulse as i64) << (up & 31),
        None => rounded(impulse as i64, FINE - shift),
    }
}

impl<F: LeEqU32> Carry for FixedI32<F> {
    type Place = i64;
    type Rest = i16;

    const NO_REST: i16 = 0;
    const REST_BYTES: usize = 2;

    #[inline]
    fn place(self) -> i64 {
        (self.to_bits() as i64) << 32
    }

    #[inline]
    fn seen(place: i64) -> Self {
        FixedI32::from_bits(i32::rounded(place, 32))
    }

    // m / 2^(32 + s) in units of 2^-32 is a whole number and a fraction. The fraction is made odd,
    // by 2^-32 of such a unit, so that its product never lies half-way: see `factor.rs`.
    #[inline]
    fn moved(place: i64, value: Self, factor: Coef<i32>, halvings: u32) -> i64 {
        let (mantissa, shift) = factor.parts();
        let (value, shift) = (value.to_bits(), shift + halvings);
        if !(33..=62).contains(&shift) {
            return place.saturating_add(scaled(value, mantissa, shift, 32));
        }
        let fraction = mantissa << (64 - shift) | 1;
        let whole = (mantissa >> (shift - 32)) + (fraction < 0) as i32;
        let part = (product_i32(value, fraction) + (1 << 31)) >> 32;
        advanced(place, product_i32(value, whole) + part)
    }

    // Below a second the product cannot leave the range.
    #[inline(always)]
    fn moved_dyadic(place: i64, value: Self, num: u32, shift: u32) -> i64 {
        let product = value.to_bits() as i64 * num as i64;
        let unit = 1_i64 << (32 - shift);
        match num >> shift {
            0 => advanced(place, product.wrapping_mul(unit)),
            _ => place.saturating_add(product.saturating_mul(unit)),
        }
    }

    #[inline]
    fn kicked((v, rest): (Self, i16), value: Self, factor: Coef<i32>) -> (Self, i16) {
        let (mantissa, shift) = factor.parts();
        let change = scaled(value.to_bits(), mantissa, shift, FINE);
        let (v, rest) = kept(fine(v.to_bits(), rest).saturating_add(change));
        (FixedI32::from_bits(v), rest)
    }

    // Each part loses at most itself, and the remainder is at most half of the whole, so that the sum
    // does not change its sign.
    #[inline]
    fn damped((v, rest): (Self, i16), loss: Coef<i32>) -> (Self, i16) {
        let (mantissa, shift) = loss.parts();
        let lost =
            scaled(v.to_bits(), mantissa, shift, FINE) + scaled(rest as i32, mantissa, shift, 0);
        let (v, rest) = kept(fine(v.to_bits(), rest) - lost);
        (FixedI32::from_bits(v), rest)
    }

    // The inverse mass finds the velocity to a unit or two; units are counted by the mass, and as a
    // velocity one unit further stands for at most one unit more, single steps find the number.
    fn pushed((v, rest): (Self, i16), impulse: Self, inv_mass: InvMass<i32>) -> (Self, i16) {
        let (mass, shift) = inv_mass.mass().parts();
        let (inverse, inverse_shift) = Coef::from(inv_mass).parts();
        let before = fine(v.to_bits(), rest);
        let wanted = units(before, mass) + exchange(impulse.to_bits(), shift);
        let change = scaled(impulse.to_bits(), inverse, inverse_shift, FINE);
        let mut after = before.saturating_add(change);
        for _ in 0..6 {
            after = after.clamp(-LIMIT, LIMIT);
            let missing = wanted.saturating_sub(units(after, mass));
            after = match missing {
                0 => break,
                -1 | 1 => after.saturating_add(missing),
                _ => {
                    let missing = missing.clamp(i32::MIN.into(), i32::MAX.into());
                    after.saturating_add(scaled(missing as i32, inverse, 30, 0))
                }
            };
        }
        let (v, rest) = kept(after);
        (FixedI32::from_bits(v), rest)
    }

    fn momentum((v, rest): (Self, i16), inv_mass: InvMass<i32>) -> f64 {
        let (mass, shift) = inv_mass.mass().parts();
        let scale = FINE as i32 - shift as i32 - F::U32 as i32;
        libm::ldexp(units(fine(v.to_bits(), rest), mass) as f64, scale)
    }

    fn left_over(place: i64) -> u64 {
        place as u32 as u64
    }

    fn halves(place: i64) -> [u64; 2] {
        [(place >> 32) as u32 as u64, place as u32 as u64]
    }

    fn of_halves([high, low]: [u64; 2]) -> Option<i64> {
        let (high, low) = (u32::try_from(high).ok()?, u32::try_from(low).ok()?);
        Some((high as i32 as i64) << 32 | low as i64)
    }

    fn rest_bits(rest: i16) -> u64 {
        (rest as u16).into()
    }

    fn of_rest_bits(bits: u64) -> Option<i16> {
        let rest = u16::try_from(bits).ok()? as i16;
        (rest.unsigned_abs() <= 1 << (FINE - 1)).then_some(rest)
    }
}

macro_rules! float_carry {
    ($float:ident, $bits:ident, $rest:ident, $lost:expr, $short:expr) => {
        impl Carry for $float {
            /// The sum, and what it has too much.
            type Place = [$float; 2];
            type Rest = $rest;

            const NO_REST: $rest = 0;
            const REST_BYTES: usize = size_of::<$rest>();

            #[inline]
            fn place(self) -> [$float; 2] {
                [self, 0.0]
            }

            #[inline]
            fn seen([sum, _]: [$float; 2]) -> $float {
                sum
            }

            #[inline]
            fn moved(
                [sum, excess]: [$float; 2],
                value: $float,
                h: $float,
                halvings: u32,
            ) -> [$float; 2] {
                let h = if halvings == 0 { h } else { 0.5 * h };
                let term = h * value - excess;
                let next = sum + term;
                [next, (next - sum) - term]
            }

            #[inline(always)]
            fn moved_dyadic(
                place: [$float; 2],
                value: $float,
                num: u32,
                shift: u32,
            ) -> [$float; 2] {
                Self::moved(place, value.dyadic(num, shift), 1.0, 0)
            }

            #[inline]
            fn kicked(
                (v, rest): ($float, $rest),
                value: $float,
                factor: $float,
            ) -> ($float, $rest) {
                let [v, excess] = Self::moved([v, $lost(rest)], value, factor, 0);
                (v, $short(excess))
            }

            #[inline]
            fn damped((v, rest): ($float, $rest), loss: $float) -> ($float, $rest) {
                let excess = $lost(rest);
                let [v, excess] = Self::moved([v, excess - loss * excess], -v, loss, 0);
                (v, $short(excess))
            }

            #[inline]
            fn pushed(kept: ($float, $rest), impulse: $float, inv_mass: $float) -> ($float, $rest) {
                Self::kicked(kept, impulse, inv_mass)
            }

            fn momentum((v, rest): ($float, $rest), inv_mass: $float) -> f64 {
                (v as f64 - $lost(rest) as f64) / inv_mass as f64
            }

            fn left_over([_, excess]: [$float; 2]) -> u64 {
                excess.bits()
            }

            fn halves(place: [$float; 2]) -> [u64; 2] {
                place.map(|half| half.to_bits().into())
            }

            fn of_halves(halves: [u64; 2]) -> Option<[$float; 2]> {
                let [sum, excess] = halves.map(|half| $bits::try_from(half).ok());
                Some([$float::from_bits(sum?), $float::from_bits(excess?)])
            }

            fn rest_bits(rest: $rest) -> u64 {
                rest.into()
            }

            fn of_rest_bits(bits: u64) -> Option<$rest> {
                $rest::try_from(bits).ok()
            }
        }
    };
}

// The upper half of its bits, rounded: what a sum has too much is small beside it, and eight digits
// of that are enough.
float_carry!(
    f32,
    u32,
    u16,
    |rest: u16| f32::from_bits((rest as u32) << 16),
    |excess: f32| { (excess.to_bits().wrapping_add(0x8000) >> 16) as u16 }
);
float_carry!(
    f64,
    u64,
    u32,
    |rest: u32| f64::from_bits((rest as u64) << 32),
    |excess: f64| { (excess.to_bits().wrapping_add(1 << 31) >> 32) as u32 }
);
