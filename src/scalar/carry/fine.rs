//! Velocities of 32 bits with remainders of 15 more: what kicks, drags and impulses do to them.
//!
//! **Momentum.** A velocity with its remainder, u in units of `2^-15`, stands for a whole number of
//! units of momentum, `p(u) = round(u m)` with m scaled to between half a unit and a whole one, so
//! that each number p has a velocity u. An impulse adds a whole number of those units; the velocity
//! becomes one that stands for the sum. What one body gains the other loses, to the bit, for ever.

/// Fractional bits of a remainder: 15, so that ±1/2 and all between fit 16 bits.
pub(in crate::scalar) const FINE: u32 = 15;

/// `wide / 2^shift`, nearest, ties away from zero; `1 <= shift <= 62` and `|wide| <= 2^62`.
#[inline]
pub(in crate::scalar) fn rounded(wide: i64, shift: u32) -> i64 {
    let half = 1 << (shift.wrapping_sub(1) & 63);
    wide.wrapping_add(half).wrapping_add(wide >> 63) >> (shift & 63)
}

/// `value * mantissa / 2^shift` in units of `2^-fraction`, at most `2^62`.
#[inline]
pub(in crate::scalar) fn scaled(value: i32, mantissa: i32, shift: u32, fraction: u32) -> i64 {
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
pub(in crate::scalar) fn changed(value: i32, remainder: i16, change: i64) -> (i32, i16) {
    let total = change + remainder as i64;
    let whole = rounded(total, FINE);
    let remainder = total.wrapping_sub(whole << FINE) as i16;
    // A change may be as large as the range is wide: only the sum has to fit.
    let sum = value as i64 + whole;
    match i32::try_from(sum) {
        Ok(value) if value != i32::MIN => (value, remainder),
        _ if sum < 0 => (-i32::MAX, 0),
        _ => (i32::MAX, 0),
    }
}

/// A velocity in units of `2^-15`.
#[inline]
pub(in crate::scalar) fn fine(value: i32, remainder: i16) -> i64 {
    ((value as i64) << FINE) + remainder as i64
}

/// The largest fine velocity.
pub(in crate::scalar) const LIMIT: i64 = (i32::MAX as i64) << FINE;

/// Units of momentum that a fine velocity stands for: `|fine| mass / 2^30` with a mass from `2^29`
/// to `2^30`, rounded; odd.
#[inline]
pub(in crate::scalar) fn units(fine: i64, mass: i32) -> i64 {
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
pub(in crate::scalar) fn exchanged(
    value: i32,
    remainder: i16,
    impulse: i32,
    (mass, shift): (i32, u32),
    (inverse, inverse_shift): (i32, u32),
) -> (i32, i16) {
    let before = fine(value, remainder);
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
    changed(value, remainder, change.clamp(-3 * LIMIT, 3 * LIMIT))
}
