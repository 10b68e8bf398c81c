//! Positions of 64 bits: what a drift adds to them.

use super::fine::{FINE, rounded, scaled};
use crate::scalar::integer::product_i32;

/// `position + change`; the upper word of `change` must have room for one more. Only the upper word
/// saturates: the lower one no longer matters there.
#[inline]
pub(super) fn advanced(position: i64, change: i64) -> i64 {
    let (low, carry) = (position as u32).overflowing_add(change as u32);
    let more = ((change >> 32) as i32).wrapping_add(carry as i32);
    let high = ((position >> 32) as i32).saturating_add(more);
    (high as i64) << 32 | low as i64
}

/// `mantissa / 2^shift` in units of `2^-32`, for shifts from 33 to 62: a whole number, and a fraction
/// that is made odd.
#[inline(always)]
pub(super) fn parted(mantissa: i32, shift: u32) -> (i32, i32) {
    let fraction = mantissa << ((64 - shift) & 31) | 1;
    (
        (mantissa >> ((shift - 32) & 31)) + (fraction < 0) as i32,
        fraction,
    )
}

/// The part of a remainder that goes with a whole number of units.
#[inline(always)]
pub(super) fn remainder_of(remainder: i16, whole: i32) -> i32 {
    (remainder as i32).wrapping_mul((whole + (1 << (FINE - 1))) >> FINE)
}

/// The same for factors from a quarter on, for those below 2^-31, and for those whose fraction has more bits
/// than [`ODD_SHIFT`] promises.
#[cold]
pub(super) fn far(position: i64, (value, remainder): (i32, i16), mantissa: i32, shift: u32) -> i64 {
    if (33..=62).contains(&shift) {
        let (whole, fraction) = parted(mantissa, shift);
        let part = (product_i32(value, fraction) + (1 << 31)) >> 32;
        let part = part + remainder_of(remainder, whole) as i64;
        return advanced(position, product_i32(value, whole) + part);
    }
    let product = product_i32(value, mantissa);
    let change = match shift.checked_sub(32) {
        None | Some(0) => product.saturating_mul(1 << (32 - shift)).max(-i64::MAX),
        Some(down) => rounded(product, down),
    };
    let remainder = scaled(remainder as i32, mantissa, shift, 32 - FINE);
    position.saturating_add(change).saturating_add(remainder)
}

#[cfg(test)]
mod tests {
    use fixed::types::I16F16;

    use super::*;
    use crate::scalar::Carry;
    use crate::scalar::factor::Coef;

    #[test]
    fn far_and_near_drift_alike() {
        let mut seed = 1_u64;
        let mut random = || {
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (seed >> 32) as i32
        };
        for round in 0..300_000 {
            let shift = 33 + round % 30;
            let (high, low, remainder) = (random(), random(), (random() >> 17) as i16);
            let position = (high as i64) << 32 | low as u32 as i64;
            let value = [random(), i32::MIN, i32::MAX, -1][(round % 7 / 2) as usize];
            let mantissa = random() >> 31 ^ (random() & i32::MAX | 1 << 30);
            let near = I16F16::drifted(
                position,
                (I16F16::from_bits(value), remainder),
                Coef::from_raw(mantissa, shift),
                0,
            );
            assert_eq!(near, far(position, (value, remainder), mantissa, shift));
            // What two short products rely on, where there is no long one.
            assert!(shift > 48 || parted(mantissa, shift).1 & 0xFFFF == 1);
        }
    }
}
