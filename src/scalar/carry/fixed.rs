//! Remainders of fixed point: positions with 32 more fractional bits, velocities with 15 more.

use fixed::FixedI32;
use fixed::types::extra::LeEqU32;

use super::Carry;
use super::drift::{advanced, far, parted, remainder_of};
use super::fine::{FINE, LIMIT, changed, exchanged, fine, rounded, scaled, units};
use crate::scalar::Scalar;
use crate::scalar::factor::{Coef, InvMass};
use crate::scalar::integer::{ODD_SHIFT, product_i32, rounded_sum_i32};

impl<F: LeEqU32> Carry for FixedI32<F> {
    type FinePosition = i64;
    type Remainder = i16;

    const NO_REMAINDER: i16 = 0;
    const REMAINDER_BYTES: usize = 2;

    #[inline]
    fn fine_position(self) -> i64 {
        (self.to_bits() as i64) << 32
    }

    // Half a unit goes up; below zero, only more than half.
    #[inline]
    fn seen(position: i64) -> Self {
        let (high, low) = ((position >> 32) as i32, position as u32);
        let up = low >= (1 << 31) + (high as u32 >> 31);
        FixedI32::from_bits(high.saturating_add(up as i32))
    }

    #[inline]
    fn beyond(position: i64, from: Self) -> (Self, i16) {
        let seen = Self::seen(position);
        // Half a unit at most, but at the end of the range.
        let remainder = rounded(position.wrapping_sub(seen.fine_position()), 32 - FINE);
        (seen.minus(from), remainder.min(1 << (FINE - 1)) as i16)
    }

    // Twice, for a sum of the other two may not fit; it saturates only where all three do.
    #[inline]
    fn mirrored(position: i64, about: Self) -> i64 {
        let about = about.fine_position();
        advanced(advanced(position.saturating_neg(), about), about)
    }

    #[inline]
    fn moved(position: i64, value: Self, factor: Coef<i32>, halvings: u32) -> i64 {
        Self::drifted(position, (value, 0), factor, halvings)
    }

    #[inline(always)]
    fn moved_dyadic(position: i64, value: Self, num: u32, shift: u32) -> i64 {
        Self::drifted_dyadic(position, (value, 0), num, shift)
    }

    // m / 2^(32 + s) in units of 2^-32 is a whole number and a fraction. The fraction is made odd,
    // by 2^-32 of such a unit, so that its product never lies half-way: see `factor.rs`. The
    // remainder of the velocity takes 2^-15 of the whole number, rounded: 11 bits at 60 Hz, 7 at 1 kHz.
    // It is at most 2^14, the number 2^30: so that part is at most 2^29, the product's 2^30, and 32 bits do.
    #[inline]
    fn drifted(position: i64, (v, remainder): (Self, i16), h: Coef<i32>, halvings: u32) -> i64 {
        let (mantissa, shift) = h.parts();
        let (v, shift) = (v.to_bits(), shift + halvings);
        if !(33..=ODD_SHIFT).contains(&shift) {
            return far(position, (v, remainder), mantissa, shift);
        }
        let (whole, fraction) = parted(mantissa, shift);
        let part = rounded_sum_i32(remainder_of(remainder, whole), v, fraction);
        advanced(position, product_i32(v, whole) + part as i64)
    }

    // A shift alone leaves its two words as they are. Below a second no product leaves the range.
    #[inline(always)]
    fn drifted_dyadic(position: i64, (v, remainder): (Self, i16), num: u32, shift: u32) -> i64 {
        let (value, unit) = (v.to_bits(), 1_i64 << (32 - shift));
        // Short products where they fit.
        let product = match num >> 16 {
            0 => (remainder as i32 * num as i32) as i64,
            _ => remainder as i64 * num as i64,
        };
        let remainder = match shift.checked_sub(32 - FINE) {
            // Below a second 2^14 of them fit 32 bits: no shift of 64.
            None | Some(0) if num >> shift == 0 => ((product as i32) << (32 - FINE - shift)) as i64,
            None | Some(0) => product << (32 - FINE - shift),
            Some(down) => rounded(product, down),
        };
        if num >> shift != 0 {
            let change = (value as i64 * num as i64).saturating_mul(unit);
            return position.saturating_add(change).saturating_add(remainder);
        }
        if num == 1 {
            let (high, low) = (value >> shift, (value as u32) << (32 - shift));
            return advanced(position, ((high as i64) << 32 | low as i64) + remainder);
        }
        let product = value as i64 * num as i64;
        advanced(position, product.wrapping_mul(unit) + remainder)
    }

    #[inline]
    fn kicked((v, remainder): (Self, i16), value: Self, factor: Coef<i32>) -> (Self, i16) {
        let (mantissa, shift) = factor.parts();
        let change = scaled(value.to_bits(), mantissa, shift, FINE);
        let (v, remainder) = changed(v.to_bits(), remainder, change);
        (FixedI32::from_bits(v), remainder)
    }

    #[inline]
    fn kicked_as(
        (v, remainder): (Self, i16),
        (value, more): (Self, i16),
        factor: Coef<i32>,
    ) -> (Self, i16) {
        let (mantissa, shift) = factor.parts();
        let change = scaled(value.to_bits(), mantissa, shift, FINE);
        let more = scaled(more as i32, mantissa, shift, 0);
        let change = change.saturating_add(more).clamp(-3 * LIMIT, 3 * LIMIT);
        let (v, remainder) = changed(v.to_bits(), remainder, change);
        (FixedI32::from_bits(v), remainder)
    }

    #[inline]
    fn reversed((v, remainder): (Self, i16)) -> (Self, i16) {
        (v.negated(), remainder.wrapping_neg())
    }

    // Each part loses at most itself, and the remainder is at most half of the whole, so that the sum
    // does not change its sign. A loss that rounds to nothing takes a unit of the remainder.
    #[inline]
    fn damped((v, remainder): (Self, i16), loss: Coef<i32>) -> (Self, i16) {
        let (mantissa, shift) = loss.parts();
        let lost = scaled(v.to_bits(), mantissa, shift, FINE)
            + scaled(remainder as i32, mantissa, shift, 0);
        let least = fine(v.to_bits(), remainder).signum() as i32 * mantissa.signum();
        let lost = if lost == 0 { least as i64 } else { lost };
        let (v, remainder) = changed(v.to_bits(), remainder, -lost);
        (FixedI32::from_bits(v), remainder)
    }

    fn pushed(
        kept: [(Self, i16); 2],
        impulse: [Self; 2],
        inv_mass: InvMass<i32>,
    ) -> [(Self, i16); 2] {
        let (mass, inverse) = (inv_mass.mass().parts(), Coef::from(inv_mass).parts());
        let of = |(v, remainder): (Self, i16), impulse: Self| {
            let (v, remainder) =
                exchanged(v.to_bits(), remainder, impulse.to_bits(), mass, inverse);
            (FixedI32::from_bits(v), remainder)
        };
        [of(kept[0], impulse[0]), of(kept[1], impulse[1])]
    }

    fn momentum((v, remainder): (Self, i16), inv_mass: InvMass<i32>) -> f64 {
        let (mass, shift) = inv_mass.mass().parts();
        let scale = FINE as i32 - shift as i32 - F::U32 as i32;
        libm::ldexp(units(fine(v.to_bits(), remainder), mass) as f64, scale)
    }

    fn left_over(position: i64) -> u64 {
        position as u32 as u64
    }

    fn remainder_left_over(remainder: i16) -> u64 {
        Self::remainder_bits(remainder)
    }

    fn halves(position: i64) -> [u64; 2] {
        [(position >> 32) as u32 as u64, position as u32 as u64]
    }

    fn from_halves([high, low]: [u64; 2]) -> Option<i64> {
        let (high, low) = (u32::try_from(high).ok()?, u32::try_from(low).ok()?);
        Some((high as i32 as i64) << 32 | low as i64)
    }

    fn remainder_bits(remainder: i16) -> u64 {
        (remainder as u16).into()
    }

    fn from_remainder_bits(bits: u64) -> Option<i16> {
        let remainder = u16::try_from(bits).ok()? as i16;
        (remainder.unsigned_abs() <= 1 << (FINE - 1)).then_some(remainder)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fixed::types::I16F16;

    #[test]
    fn dyadic_drift_is_exact() {
        let steps = [
            (1, 1),
            (1, 6),
            (1, 17),
            (3, 1),
            (70_000, 17),
            (70_000, 1),
            (1 << 24, 1),
        ];
        for (num, shift) in steps.map(|(num, shift)| (num as i64, shift)) {
            for value in -50..50 {
                for remainder in [-1 << 14, -1, 0, 3, 1 << 14] {
                    let fine = ((value as i64) << FINE) + remainder as i64;
                    let position = 0x0012_3456_89AB_CDEF;
                    let kept = (I16F16::from_bits(value), remainder as i16);
                    assert_eq!(
                        I16F16::drifted_dyadic(position, kept, num as u32, shift),
                        position + ((fine * num) << (32 - FINE - shift))
                    );
                }
            }
        }
    }
}
