//! What a body that carries holds in fixed point, as exact integers.

use fixstep::{Body, Carried, Carry, Factor, Saved, Scalar, Stored};

use crate::support::Grid;

/// 32-bit fixed point that carries: its places are whole numbers of `2^-32` units, its remainders of
/// `2^-15`.
pub trait Fine:
    Grid + Stored + Carry<FinePosition = i64, Remainder = i16> + Scalar<InvMass: Stored>
{
}

impl<S> Fine for S where
    S: Grid + Stored + Carry<FinePosition = i64, Remainder = i16> + Scalar<InvMass: Stored>
{
}

/// Fractional bits of a remainder.
pub const FINE: u32 = 15;

/// Largest velocity with its remainder.
pub const LIMIT: i128 = (i32::MAX as i128) << FINE;

fn words<S: Fine>(body: &Carried<S>) -> Vec<u64> {
    let mut words = Vec::new();
    body.save(&mut |word, _| words.push(word));
    words
}

/// Both parts of the position in units of `2^-32`, as the snapshot holds them.
pub fn places<S: Fine>(body: &Carried<S>) -> [i128; 2] {
    let words = words(body);
    let place = |i: usize| ((words[i] as u32 as i32 as i128) << 32) + words[i + 1] as i128;
    [place(0), place(2)]
}

/// Both remainders of the velocity, in units of `2^-15`.
pub fn rests<S: Fine>(body: &Carried<S>) -> [i16; 2] {
    let words = words(body);
    [words[7], words[8]].map(|bits| bits as u16 as i16)
}

/// Both parts of the velocity in units of `2^-15`.
pub fn fine<S: Fine>(body: &Carried<S>) -> [i128; 2] {
    let (v, [x, y]) = (body.velocity(), rests(body));
    [(v.x, x), (v.y, y)].map(|(v, rest)| fine_of(v, rest))
}

pub fn fine_of<S: Grid>(v: S, rest: i16) -> i128 {
    ((v.units() as i128) << FINE) + rest as i128
}

/// A coefficient is `m / 2^62` of a whole number m: mantissa and shift have 31 and 62 bits at most.
pub fn coef<S: Scalar>(coef: S::Coef) -> i128 {
    let wide = coef.to_f64() * (1_u64 << 62) as f64;
    assert!(wide == wide.trunc());
    wide as i128
}

/// `num / 2^shift`, nearest, ties away from zero.
pub fn rounded(num: i128, shift: u32) -> i128 {
    let magnitude = num.unsigned_abs();
    let up = (magnitude + (1 << shift >> 1)) >> shift;
    up as i128 * num.signum()
}

/// A mass as `M / 2^shift` with M above `2^29` and at most `2^30`.
pub fn mass<S: Scalar>(inv_mass: S::InvMass) -> (i128, u32) {
    let mut mass = S::mass(inv_mass).to_f64();
    let mut shift = 0;
    while mass <= (1 << 29) as f64 {
        (mass, shift) = (2.0 * mass, shift + 1);
    }
    assert!(mass == mass.trunc() && mass <= (1 << 30) as f64);
    (mass as i128, shift)
}

/// An exact multiple of `2^-64` as that multiple.
pub fn exact(value: f64) -> i128 {
    let wide = value * 2.0_f64.powi(64);
    assert!(wide == wide.trunc() && wide.abs() < 2.0_f64.powi(126));
    wide as i128
}

/// The momentum of a body in units of `2^-64` kg m/s.
pub fn momentum<S: Carry>(body: &Carried<S>) -> [i128; 2] {
    body.momentum().array().map(exact)
}

/// One over the mass that `momentum` counts with.
pub fn counted_mass<S: Scalar, B: Body<S = S>>(body: &B) -> f64 {
    S::mass(body.inv_mass()).to_f64()
}
