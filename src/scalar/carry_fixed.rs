//! Remainders of fixed point: positions with 32 more fractional bits, velocities with 15 more.
//!
//! **Momentum.** A velocity with its remainder, u in units of `2^-15`, stands for a whole number of
//! units of momentum, `p(u) = round(u m)` with m scaled to between half a unit and a whole one, so
//! that each number p has a velocity u. An impulse adds a whole number of those units; the velocity
//! becomes one that stands for the sum. What one body gains the other loses, to the bit, for ever.

use fixed::FixedI32;
use fixed::types::extra::LeEqU32;

use super::carry::Carry;
use super::factor::{Coef, InvMass};
use super::high_product::product_i32;

/// Fractional bits of a remainder: 15, so that ±1/2 and all between fit 16 bits.
const FINE: u32 = 15;

/// `wide / 2^shift`, nearest, ties away from zero; `1 <= shift <= 62` and `|wide| <= 2^62`.
#[inline]
fn rounded(wide: i64, shift: u32) -> i64 {
    let half = 1 << (shift.wrapping_sub(1) & 63);
    wide.wrapping_add(half).wrapping_add(wide >> 63) >> (shift & 63)
}

/// `value * mantissa / 2^shift` in units of `2^-fraction`, at most `2^62`.
#[inline]
fn scaled(value: i32, mantissa: i32, shift: u32, fraction: u32) -> i64 {
    const LIMIT: i64 = 1 << 62;
    let product = value as i64 * mantissa as i64;
    match shift.checked_sub(fraction) {
        None | Some(0) => {
            let product = product.saturating_mul(1 << (fraction - shift));
            product.clamp(-LIMIT, LIMIT)
        }
        Some(down) => rounded(product, down),
    }
}

/// A velocity and its remainder after a change in units of `2^-15`, at most `2^62` of them. The
/// remainder is at most half a unit of the type.
#[inline]
fn changed(value: i32, rest: i16, change: i64) -> (i32, i16) {
    let total = change + rest as i64;
    let whole = rounded(total, FINE);
    let rest = total.wrapping_sub(whole << FINE) as i16;
    // A change may be as large as the range is wide: only the sum has to fit.
    let sum = value as i64 + whole;
    match i32::try_from(sum) {
        Ok(value) if value != i32::MIN => (value, rest),
        _ if sum < 0 => (-i32::MAX, 0),
        _ => (i32::MAX, 0),
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

/// The same for factors from a quarter on, or below `2^-31`.
#[cold]
fn far(place: i64, (value, rest): (i32, i16), mantissa: i32, shift: u32) -> i64 {
    let product = product_i32(value, mantissa);
    let change = match shift.checked_sub(32) {
        None | Some(0) => product.saturating_mul(1 << (32 - shift)).max(-i64::MAX),
        Some(down) => rounded(product, down),
    };
    let rest = scaled(rest as i32, mantissa, shift, 32 - FINE);
    place.saturating_add(change).saturating_add(rest)
}

/// A velocity in units of `2^-15`.
#[inline]
fn fine(value: i32, rest: i16) -> i64 {
    ((value as i64) << FINE) + rest as i64
}

/// The largest fine velocity.
const LIMIT: i64 = (i32::MAX as i64) << FINE;

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

/// A velocity and its remainder after an impulse on a mass, of which the inverse is known too.
///
/// The inverse finds the velocity to a unit or two. Units are counted by the mass; as a velocity one
/// unit further stands for at most one unit more, single steps find the number that is wanted.
fn exchanged(
    value: i32,
    rest: i16,
    impulse: i32,
    (mass, shift): (i32, u32),
    (inverse, inverse_shift): (i32, u32),
) -> (i32, i16) {
    let before = fine(value, rest);
    // A mass of m / 2^shift counts momentum in units of 2^(FINE - shift) of the type's.
    let gained = match shift.checked_sub(FINE) {
        Some(up) => (impulse as i64) << (up & 31),
        None => rounded(impulse as i64, FINE - shift),
    };
    let wanted = units(before, mass) + gained;
    let mut change = scaled(impulse, inverse, inverse_shift, FINE);
    for _ in 0..6 {
        let after = before.saturating_add(change).clamp(-LIMIT, LIMIT);
        let missing = wanted - units(after, mass);
        change += match missing {
            0 => break,
            -1 | 1 => missing,
            _ => {
                let missing = missing.clamp(-i32::MAX as i64, i32::MAX as i64);
                scaled(missing as i32, inverse, 30, 0)
            }
        };
    }
    changed(value, rest, change.clamp(-3 * LIMIT, 3 * LIMIT))
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

    // Half a unit goes up; below zero, only more than half.
    #[inline]
    fn seen(place: i64) -> Self {
        let (high, low) = ((place >> 32) as i32, place as u32);
        let up = low >= (1 << 31) + (high as u32 >> 31);
        FixedI32::from_bits(high.saturating_add(up as i32))
    }

    #[inline]
    fn moved(place: i64, value: Self, factor: Coef<i32>, halvings: u32) -> i64 {
        Self::drifted(place, (value, 0), factor, halvings)
    }

    #[inline(always)]
    fn moved_dyadic(place: i64, value: Self, num: u32, shift: u32) -> i64 {
        Self::drifted_dyadic(place, (value, 0), num, shift)
    }

    // m / 2^(32 + s) in units of 2^-32 is a whole number and a fraction. The fraction is made odd,
    // by 2^-32 of such a unit, so that its product never lies half-way: see `factor.rs`. The
    // remainder of the velocity takes 2^-15 of the whole number, rounded: 11 bits at 60 Hz, 7 at 1 kHz.
    #[inline]
    fn drifted(place: i64, (v, rest): (Self, i16), h: Coef<i32>, halvings: u32) -> i64 {
        let (mantissa, shift) = h.parts();
        let (v, shift) = (v.to_bits(), shift + halvings);
        if !(33..=62).contains(&shift) {
            return far(place, (v, rest), mantissa, shift);
        }
        let fraction = mantissa << (64 - shift) | 1;
        let whole = (mantissa >> (shift - 32)) + (fraction < 0) as i32;
        let part = (product_i32(v, fraction) + (1 << 31)) >> 32;
        let rest = (rest as i32).wrapping_mul((whole + (1 << (FINE - 1))) >> FINE);
        advanced(place, product_i32(v, whole) + part + rest as i64)
    }

    // A shift alone leaves its two words as they are. Below a second no product leaves the range.
    #[inline(always)]
    fn drifted_dyadic(place: i64, (v, rest): (Self, i16), num: u32, shift: u32) -> i64 {
        let (value, unit) = (v.to_bits(), 1_i64 << (32 - shift));
        // Short products where they fit.
        let product = match num >> 16 {
            0 => (rest as i32 * num as i32) as i64,
            _ => rest as i64 * num as i64,
        };
        let rest = match shift.checked_sub(32 - FINE) {
            None | Some(0) => product << (32 - FINE - shift),
            Some(down) => rounded(product, down),
        };
        if num >> shift != 0 {
            let change = (value as i64 * num as i64).saturating_mul(unit);
            return place.saturating_add(change).saturating_add(rest);
        }
        if num == 1 {
            let (high, low) = (value >> shift, (value as u32) << (32 - shift));
            return advanced(place, ((high as i64) << 32 | low as i64) + rest);
        }
        let product = value as i64 * num as i64;
        advanced(place, product.wrapping_mul(unit) + rest)
    }

    #[inline]
    fn kicked((v, rest): (Self, i16), value: Self, factor: Coef<i32>) -> (Self, i16) {
        let (mantissa, shift) = factor.parts();
        let change = scaled(value.to_bits(), mantissa, shift, FINE);
        let (v, rest) = changed(v.to_bits(), rest, change);
        (FixedI32::from_bits(v), rest)
    }

    // Each part loses at most itself, and the remainder is at most half of the whole, so that the sum
    // does not change its sign. A loss that rounds to nothing takes a unit of the remainder.
    #[inline]
    fn damped((v, rest): (Self, i16), loss: Coef<i32>) -> (Self, i16) {
        let (mantissa, shift) = loss.parts();
        let lost =
            scaled(v.to_bits(), mantissa, shift, FINE) + scaled(rest as i32, mantissa, shift, 0);
        let least = fine(v.to_bits(), rest).signum() as i32 * mantissa.signum();
        let lost = if lost == 0 { least as i64 } else { lost };
        let (v, rest) = changed(v.to_bits(), rest, -lost);
        (FixedI32::from_bits(v), rest)
    }

    fn pushed(
        kept: [(Self, i16); 2],
        impulse: [Self; 2],
        inv_mass: InvMass<i32>,
    ) -> [(Self, i16); 2] {
        let (mass, inverse) = (inv_mass.mass().parts(), Coef::from(inv_mass).parts());
        let of = |(v, rest): (Self, i16), impulse: Self| {
            let (v, rest) = exchanged(v.to_bits(), rest, impulse.to_bits(), mass, inverse);
            (FixedI32::from_bits(v), rest)
        };
        [of(kept[0], impulse[0]), of(kept[1], impulse[1])]
    }

    fn momentum((v, rest): (Self, i16), inv_mass: InvMass<i32>) -> f64 {
        let (mass, shift) = inv_mass.mass().parts();
        let scale = FINE as i32 - shift as i32 - F::U32 as i32;
        libm::ldexp(units(fine(v.to_bits(), rest), mass) as f64, scale)
    }

    fn left_over(place: i64) -> u64 {
        place as u32 as u64
    }

    fn rest_left_over(rest: i16) -> u64 {
        Self::rest_bits(rest)
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
