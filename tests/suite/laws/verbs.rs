//! What gravitation and quadratic drag ask of a scalar: the inverse of a length, a mass from its
//! inverse, and a scalar as a factor. Judged in whole numbers of up to 256 bits.

use fixstep::Scalar;
use fixstep::scalar::Factor;

use crate::laws::integer::{Integer, Integers};
use crate::laws::judge::{Dyadic, Judge, Random, odd, ratio, same};

/// `m² q` as its high and its low 128 bits, `m < 2^64`.
fn square_times(m: u128, q: u128) -> [u128; 2] {
    const LOW: u128 = u64::MAX as u128;
    let square = m * m;
    let ([a, b], [c, d]) = ([square >> 64, square & LOW], [q >> 64, q & LOW]);
    let middle = a * d + ((b * d) >> 64); // below 2^128: (2^64 - 1)² + 2^64 is
    let (middle, carry) = middle.overflowing_add(b * c);
    let high = a * c + (middle >> 64) + (u128::from(carry) << 64);
    [high, (middle << 64) | ((b * d) & LOW)]
}

fn power_of_two(exponent: u32) -> [u128; 2] {
    match exponent {
        0..=127 => [0, 1 << exponent],
        _ => [1 << (exponent - 128), 0],
    }
}

/// The same number with at least `bits` bits of mantissa.
pub fn with_bits(mut number: Dyadic, bits: u32) -> Dyadic {
    while number.mantissa != 0 && number.mantissa.unsigned_abs() >> (bits - 1) == 0 {
        (number.mantissa, number.shift) = (2 * number.mantissa, number.shift + 1);
    }
    number
}

/// `|m - 2^shift / sqrt(q)| <= units`, from both sides and squared.
pub fn is_inverse_root(q: u128, inverse: Dyadic, units: u128, saturated: bool) -> bool {
    let (m, one) = (inverse.mantissa as u128, power_of_two(2 * inverse.shift));
    let low_enough = square_times(m.saturating_sub(units), q) <= one;
    let high_enough = saturated || one <= square_times(m + units, q);
    inverse.mantissa > 0 && low_enough && high_enough
}

/// One unit of a mantissa of 31 bits. With the root R in `2^31..2^32` and r its whole part, the
/// mantissa is `(2^62 - 1) / r` rounded down: above `2^62 / R` by less than `2^62 / (r (r + 1)) < 1`,
/// below it by at most one. The same with 63 bits.
fn inverse_length<S: Integer>(v: [S; 2], softening: S, bits: u32) {
    let parts = [v[0], v[1], softening].map(|s| s.raw().unsigned_abs());
    let q: u128 = parts.iter().map(|s| s * s).sum();
    let got = Integers::represented(S::inverse_length(v, softening));
    if q == 0 {
        assert_eq!(got.mantissa, 0, "{got:?}");
        return;
    }
    // The largest coefficient: a mantissa of ones, halved.
    let largest = got.shift == 1 && got.mantissa == (1 << bits) - 1;
    let mut inverse = with_bits(got, bits);
    inverse.shift += S::FRACTION;
    let right = is_inverse_root(q, inverse, 1, largest);
    assert!(right, "{v:?} {softening:?} gave {got:?}");
}

/// Signs and the order of the components do not matter.
pub fn even<S: Scalar, J: Judge<S>>(v: [S; 2], softening: S) {
    let plain = S::inverse_length(v, softening);
    let flipped = |s: S| if J::has_negative(s) { s.negated() } else { s };
    let [x, y] = v;
    for other in [[flipped(x), y], [x, flipped(y)], v.map(flipped), [y, x]] {
        assert_eq!(S::inverse_length(other, softening), plain, "{v:?}");
    }
    assert_eq!(S::inverse_length(v, flipped(softening)), plain, "{v:?}");
}

/// Every triple of corners and `count` others; of as many `bits` as a mantissa has at least.
pub fn inverse_lengths<S: Integer>(bits: u32, count: u64) {
    let corners = <Integers as Judge<S>>::corners();
    let check = |v: [S; 2], softening: S| {
        inverse_length(v, softening, bits);
        even::<S, Integers>(v, softening);
    };
    for &x in &corners {
        for &y in &corners {
            corners
                .iter()
                .for_each(|&softening| check([x, y], softening));
        }
    }
    let mut random = Random(count);
    for i in 0..count {
        let [x, y, softening] = [(); 3].map(|_| Integers::any(random.next()));
        check([x, y], if i % 2 == 0 { softening } else { S::ZERO });
    }
}

/// `|m a - 2^k| <= a / 2` with the mass `m / 2^i` and its inverse `a / 2^j`, k = i + j.
fn is_nearest_mass<S: Scalar, J: Judge<S>>(inverse: S::InvMass, bits: u32) {
    let (exact, got) = (J::represented(inverse), J::represented(S::mass(inverse)));
    let mass = with_bits(got, bits);
    let error = mass.mantissa * exact.mantissa - (1 << (mass.shift + exact.shift));
    assert!(
        2 * error.abs() <= exact.mantissa,
        "{inverse:?} gave {got:?}"
    );
    // Either both are powers of two or neither is.
    let odd = |number: Dyadic| number.mantissa >> number.mantissa.trailing_zeros();
    assert_eq!(odd(exact) == 1, odd(got) == 1, "{inverse:?} gave {got:?}");
}

/// Masses of `2^-9` to `2^18` kg, of which powers of two are exact; the others nearest in `bits`.
pub fn masses<S: Scalar, J: Judge<S>>(bits: u32, count: u64) {
    let check = |num, den| {
        is_nearest_mass::<S, J>(S::InvMass::new(ratio(num, den)).unwrap(), bits);
    };
    for shift in 0..=18 {
        check(1, 1 << shift);
        check(1 << shift.min(9), 1);
    }
    let mut random = Random(count);
    for _ in 0..count {
        let any = random.next();
        let (num, den) = (any & 0xFF_FFFF | 1 << 23, any >> 40 | 1 << 23);
        check(num as i64, den << (any >> 24 & 15));
    }
}

/// A scalar as a factor is the scalar, for every pair of corners and `count` others.
pub fn coefs<S: Scalar, J: Judge<S>>(count: u64) {
    let check = |a: S, b: S| {
        same(a.coef().scale(b), a.times(b), ("coef", a, b));
        same(a.coef().scale(b), J::product(a, b), ("coef", a, b));
        odd::<S, J>(a, |a| a.coef().scale(b));
    };
    for a in J::corners() {
        J::corners().into_iter().for_each(|b| check(a, b));
        let value = a.to_f64();
        assert!(a.coef().to_f64() == value || value.is_nan(), "{a:?}");
    }
    let mut random = Random(count);
    for _ in 0..count {
        check(J::any(random.next()), J::any(random.next()));
    }
}
