//! Angles for fixed point: a spin of F fractional bits is `2^-F` turns a second.
//!
//! ```text
//! m / 2^k s  ·  n 2^-F turns/s  =  n m / 2^(k + F - 32)  units of 2^-32 turns
//! ```
//!
//! In 32 bits that factor is a whole number, whose product wraps as the angle does, and a fraction, made
//! odd so that its product never lies half-way: see `factor.rs`. It adds `2^-32` of a unit to it,
//! 5e-11 of `h` in an `I8F24` at 60 Hz.

use fixed::types::extra::{LeEqU32, LeEqU64};
use fixed::{FixedI32, FixedI64};

use super::circle::{circle_u32, circle_u64};
use super::{Angular, CarryAngular};
use crate::scalar::carry::fine::{FINE, changed, fine, rounded, scaled};
use crate::scalar::factor::{Coef, InvMass};
use crate::scalar::integer::{Raw, product_i32, rounded_product_i32};

/// `m / 2^(shift - 64)`, modulo `2^64`: what one unit of a spin adds, in units of `2^-64` turns. Without a branch,
/// so that a loop over bodies makes it once. From a shift of 64 on it loses bits, 2 in an `I2F30` at 60 Hz.
#[inline(always)]
fn rate(mantissa: i32, shift: u32) -> i64 {
    let (up, down) = (64_u32.saturating_sub(shift), shift.saturating_sub(64));
    ((mantissa as i64) << (up & 63)) >> (down & 63)
}

/// `n` times that, rounded to units of `2^-32` turns.
#[inline(always)]
fn steps_i32(n: i32, mantissa: i32, shift: u32) -> u32 {
    let rate = rate(mantissa, shift) | 1;
    let (whole, fraction) = ((rate >> 32) as i32, rate as i32);
    let whole = whole.wrapping_add((fraction < 0) as i32);
    n.wrapping_mul(whole)
        .wrapping_add(rounded_product_i32(n, fraction)) as u32
}

/// `n m / 2^(shift - 64)`, modulo `2^64`, in the same way.
fn steps_i64(n: i64, mantissa: i64, shift: u32) -> u64 {
    let product = n as i128 * mantissa as i128;
    match shift.checked_sub(64) {
        None | Some(0) => (product as u64) << (64 - shift).min(63),
        Some(down) => {
            let down = down.min(126);
            ((product + (1 << (down - 1)) + (product >> 127)) >> down) as u64
        }
    }
}

macro_rules! fixed_angular {
    ($fixed:ident<$bound:ident>, $raw:ident, $wide:ident, $turns:ident, $steps:path, $circle:path,
     $tau:literal) => {
        impl<F: $bound> Angular for $fixed<F> {
            type Turns = $turns;
            type Unit = $raw;

            const TAU: Coef<$raw> = Coef::from_raw($tau, $raw::BITS - 4);
            const INFINITE_MASS: InvMass<$raw> = InvMass(0);

            #[inline]
            fn advanced(angle: $turns, spin: Self, h: Coef<$raw>, halvings: u32) -> $turns {
                let (mantissa, shift) = h.parts();
                angle.wrapping_add($steps(spin.to_bits(), mantissa, shift + halvings + F::U32))
            }

            #[inline(always)]
            fn advanced_dyadic(angle: $turns, spin: Self, num: u32, shift: u32) -> $turns {
                let (n, num) = (spin.to_bits(), num as $raw);
                let steps = match (shift + F::U32).checked_sub($turns::BITS) {
                    None | Some(0) => {
                        let up = $turns::BITS - shift - F::U32;
                        (n.wrapping_mul(num) as $turns).wrapping_shl(up)
                    }
                    Some(down) => {
                        let product = n as $wide * num as $wide;
                        let half = 1 << (down - 1);
                        ((product + half + (product >> ($wide::BITS - 1))) >> down) as $turns
                    }
                };
                angle.wrapping_add(steps)
            }

            #[inline]
            fn part_of(angle: $turns, part: Coef<$raw>) -> $turns {
                part.scale(angle as $raw) as $turns
            }

            #[inline]
            fn circle(angle: $turns) -> [$raw; 2] {
                $circle(angle)
            }

            #[inline]
            fn rotated([cos, sin]: [$raw; 2], v: [Self; 2]) -> [Self; 2] {
                let v = v.map(Self::to_bits);
                let turned = |by| Raw::rounded(Raw::dot(by, v), $raw::BITS - 2);
                [turned([cos, -sin]), turned([sin, cos])].map($fixed::from_bits)
            }

            #[inline]
            fn opposite(unit: $raw) -> $raw {
                -unit
            }

            #[inline]
            fn from_unit(unit: $raw) -> Self {
                $fixed::from_bits(Raw::rounded((unit as $wide) << F::U32, $raw::BITS - 2))
            }

            fn weighed(sum: $wide, factor: Coef<$raw>) -> Self {
                let ((value, up), (mantissa, shift)) = ($raw::renormalised(sum), factor.parts());
                let product = value.product(mantissa);
                $fixed::from_bits(match (shift + F::U32).checked_sub(up) {
                    None | Some(0) => {
                        let wide = product.saturating_mul(1 << (up - shift - F::U32));
                        wide.clamp(-$raw::MAX as $wide, $raw::MAX as $wide) as $raw
                    }
                    // A product of two mantissas is less than half of what 63 bits would take away.
                    Some(down) if down > 2 * $raw::BITS - 2 => 0,
                    Some(down) => Raw::rounded(product, down),
                })
            }
        }
    };
}

fixed_angular!(
    FixedI32<LeEqU32>,
    i32,
    i64,
    u32,
    steps_i32,
    circle_u32,
    0x6487_ED51
);
fixed_angular!(
    FixedI64<LeEqU64>,
    i64,
    i128,
    u64,
    steps_i64,
    circle_u64,
    0x6487_ED51_10B4_611A
);

/// `value m / 2^(shift - 64)` modulo `2^64`, for shifts of 126 at most.
#[inline]
fn fine_steps(value: i32, mantissa: i32, shift: u32) -> u64 {
    let product = value as i64 * mantissa as i64;
    match shift.checked_sub(64) {
        None | Some(0) => (product as u64) << (64 - shift).min(63),
        Some(down) => rounded(product, down) as u64,
    }
}

/// A spin with its remainder times [`rate`], exact but for the last bit of the remainder's share.
#[inline(always)]
fn fine_rates(spin: i32, remainder: i16, rate: i64) -> u64 {
    let fraction = rate as i32;
    let whole = ((rate >> 32) as i32).wrapping_add((fraction < 0) as i32);
    let steps = (spin.wrapping_mul(whole) as u64) << 32;
    let remainder = remainder as i32;
    let share = rounded(product_i32(remainder, fraction), FINE);
    steps
        .wrapping_add(product_i32(spin, fraction) as u64)
        .wrapping_add((product_i32(remainder, whole) as u64) << (32 - FINE))
        .wrapping_add(share as u64)
}

/// The same where the rate has more bits than that.
#[cold]
#[inline(never)]
fn finer_rates(spin: i32, remainder: i16, mantissa: i32, shift: u32) -> u64 {
    fine_steps(spin, mantissa, shift).wrapping_add(fine_steps(
        remainder.into(),
        mantissa,
        shift + FINE,
    ))
}

// The angle has 64 bits: at 60 Hz an `I16F16` and its remainder lose none.
impl<F: LeEqU32> CarryAngular for FixedI32<F> {
    type Fine = u64;

    #[inline]
    fn fine(angle: u32) -> u64 {
        (angle as u64) << 32
    }

    // Half a unit goes up; in the upper half of the turn, which is the negative one, only more than half.
    #[inline]
    fn coarse(fine: u64) -> u32 {
        let (high, low) = ((fine >> 32) as u32, fine as u32);
        let up = low >= (1 << 31) + (high >> 31);
        high.wrapping_add(up as u32)
    }

    #[inline(always)]
    fn fine_rotated(fine: u64, (spin, remainder): (Self, i16), h: Coef<i32>, halvings: u32) -> u64 {
        let ((mantissa, shift), spin) = (h.parts(), spin.to_bits());
        let shift = shift + halvings + F::U32;
        fine.wrapping_add(match shift {
            65.. => finer_rates(spin, remainder, mantissa, shift),
            _ => fine_rates(spin, remainder, rate(mantissa, shift)),
        })
    }

    #[inline(always)]
    fn fine_rotated_dyadic(fine: u64, (spin, remainder): (Self, i16), num: u32, shift: u32) -> u64 {
        let (num, shift) = (num as i32, shift + F::U32);
        fine.wrapping_add(fine_steps(spin.to_bits(), num, shift))
            .wrapping_add(fine_steps(remainder as i32, num, shift + FINE))
    }

    fn twisted((spin, remainder): (Self, i16), sum: i64, factor: Coef<i32>) -> (Self, i16) {
        let ((value, up), (mantissa, shift)) = (Raw::renormalised(sum), factor.parts());
        let shift = shift + F::U32;
        let change = match shift.checked_sub(up) {
            None => scaled(value, mantissa, 0, FINE + up - shift),
            Some(down) if down > 62 + FINE => 0,
            Some(down) => scaled(value, mantissa, down, FINE),
        };
        let (spin, remainder) = changed(spin.to_bits(), remainder, change);
        (FixedI32::from_bits(spin), remainder)
    }

    fn kept_to_f64((spin, remainder): (Self, i16)) -> f64 {
        fine(spin.to_bits(), remainder) as f64 / (1_u64 << (F::U32 + FINE)) as f64
    }

    fn fine_halves(fine: u64) -> [u64; 2] {
        [fine >> 32, fine & u32::MAX as u64]
    }

    fn from_fine_halves([high, low]: [u64; 2]) -> Option<u64> {
        let [high, low] = [u32::try_from(high).ok()?, u32::try_from(low).ok()?];
        Some((high as u64) << 32 | low as u64)
    }
}
