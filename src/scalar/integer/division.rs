//! Root and quotient of a number of 64 bits by divisions of 32, which a core has or calls.
//!
//! ```text
//! n = a B² + b B + c      B = 2^16, then 2^8;  one of the highest two bits is set
//! root a = s, remainder r;  (r B + b) / 2 s = q, remainder u
//! root n = s B + q, remainder u B + c - q²; one less where that is negative
//! ```
//!
//! Source of the root: Zimmermann, "Karatsuba Square Root", INRIA RR-3805 (1999). The quotient is
//! long division in two digits, as Knuth's "The Art of Computer Programming" vol. 2, 4.3.1 has it.

use core::num::NonZero;

/// The root of `n 2^up`, rounded down, and the even `up` that makes it as large as 32 bits hold;
/// zero for zero.
#[inline]
pub(in crate::scalar) fn root_u64(n: u64) -> (u32, u32) {
    // Halves apart: zeros and shifts of 64 bits are calls on a small core.
    let (high, low, words) = match (n >> 32) as u32 {
        0 => (n as u32, 0, 32),
        high => (high, n as u32, 0),
    };
    if high == 0 {
        return (0, 0);
    }
    let up = high.leading_zeros() & 30;
    let (high, low) = shifted(high, low, up);
    let (s, r) = root_u32(high);
    let (b, c) = (low >> 16, low & 0xFFFF);
    // Half of both: r is at most 2 s, so this fits.
    let half = (r << 15) + (b >> 1);
    let divisor = s | 1 << 15;
    let (q, u) = (half / divisor, (half % divisor) << 1 | b & 1);
    // q is at most 2^16, for r is at most 2 s; a remainder u from 2^16 on is at least q². So 32 bits compare.
    let less = u >> 16 == 0 && (q >> 16 != 0 || (u << 16 | c) < q * q);
    let root = (s << 16).wrapping_add(q).wrapping_sub(less as u32);
    (root, words + up)
}

/// Both words of `n 2^up`, for an `up` below 32.
#[inline]
fn shifted(high: u32, low: u32, up: u32) -> (u32, u32) {
    (high << up | low >> 1 >> (31 - up), low << up)
}

/// The root of an `n` from `2^30` and what is left; in the same way from half as many bits.
#[inline]
fn root_u32(n: u32) -> (u32, u32) {
    let (s, r) = root_u16(n >> 16);
    let (b, c) = (n >> 8 & 0xFF, n & 0xFF);
    let (over, divisor) = (r << 8 | b, (s | 1 << 7) << 1);
    let (q, u) = (over / divisor, over % divisor);
    let (root, remainder) = ((s << 8) + q, (u << 8 | c).wrapping_sub(q * q));
    if (remainder as i32) < 0 {
        return (root - 1, remainder.wrapping_add(root << 1).wrapping_sub(1));
    }
    (root, remainder)
}

/// The root of an `n` from `2^14`, bit by bit, and what is left.
#[inline]
fn root_u16(n: u32) -> (u32, u32) {
    let (mut s, mut remainder) = (1 << 7, n.wrapping_sub(1 << 14));
    for place in (0..7).rev() {
        let more = (s << 1 | 1 << place) << place;
        if remainder >= more {
            remainder -= more;
            s |= 1 << place;
        }
    }
    (s, remainder)
}

/// Quotient and remainder; `None` where the quotient does not fit.
#[inline]
pub(in crate::scalar) fn divide_u64(n: u64, divisor: NonZero<u32>) -> Option<(u32, u32)> {
    let (high, low) = ((n >> 32) as u32, n as u32);
    if high >= divisor.get() {
        return None;
    }
    let up = divisor.leading_zeros();
    let (high, low) = shifted(high, low, up);
    let (mut quotient, mut remainder, mut low) = (0, high, low);
    for _ in 0..2 {
        let next = digit(remainder, low >> 16, divisor.get() << up);
        (quotient, remainder, low) = (quotient << 16 | next.0, next.1, low << 16);
    }
    Some((quotient, remainder >> up))
}

/// `(high 2^16 + low) / divisor` with its remainder, for a divisor with its highest bit set and a smaller
/// `high`. The digit that the divisor's upper half gives is at most two too large.
#[inline]
fn digit(high: u32, low: u32, divisor: u32) -> (u32, u32) {
    let upper = divisor >> 16 | 1 << 15;
    let mut digit = (high / upper).min(0xFFFF);
    let mut remainder = high - digit * upper;
    let lower = divisor & 0xFFFF;
    while remainder >> 16 == 0 && digit * lower > (remainder << 16 | low) {
        digit -= 1;
        remainder += upper;
    }
    (
        digit,
        (high << 16 | low).wrapping_sub(digit.wrapping_mul(divisor)),
    )
}

/// What is divided at once: a core of 32 bits has no division of 64.
#[cfg(target_pointer_width = "64")]
pub(crate) type Word = u64;
#[cfg(not(target_pointer_width = "64"))]
pub(crate) type Word = u32;

/// Quotient and remainder of words; on cores that cannot divide `None` for a divisor from 2^31 on.
#[cfg(not(all(target_arch = "arm", not(target_has_atomic = "32"))))]
#[inline]
pub(crate) fn divide_words(n: Word, divisor: NonZero<Word>) -> Option<(Word, Word)> {
    Some((n / divisor, n % divisor))
}

/// The same on cores that cannot divide.
#[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
#[inline]
pub(crate) fn divide_words(n: Word, divisor: NonZero<Word>) -> Option<(Word, Word)> {
    let divisor = Some(divisor).filter(|by| by.get() >> 31 == 0)?;
    super::bitwise::divide_short(n.into(), divisor)
}

pub(in crate::scalar) fn root_u128(n: u128) -> (u64, u32) {
    let up = n.leading_zeros() & 126;
    ((n << up).isqrt() as u64, up)
}

pub(in crate::scalar) fn divide_u128(n: u128, divisor: NonZero<u64>) -> Option<(u64, u64)> {
    let divisor = NonZero::<u128>::from(divisor);
    let quotient = u64::try_from(n / divisor).ok()?;
    Some((quotient, (n % divisor) as u64))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers of every length, and those beside powers of two and of roots.
    fn numbers() -> impl Iterator<Item = u64> {
        let mut seed = 1_u64;
        let random = (0..200_000).map(move |i| {
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (seed ^ seed >> 32) >> (i & 63)
        });
        let squares = random.clone().map(|n| (n >> 32) * (n >> 32));
        let corners = (0..64).map(|bit| 1 << bit);
        let near = |n: u64| [n.wrapping_sub(1), n, n.wrapping_add(1)];
        random.chain(squares.chain(corners).flat_map(near))
    }

    #[test]
    fn root_is_the_one_of_the_library() {
        for n in numbers() {
            let (root, up) = root_u64(n);
            assert_eq!(root, (n << up).isqrt() as u32, "{n}");
            assert!(n == 0 || (n << up) >> 62 != 0, "{n}");
        }
    }

    #[test]
    fn quotient_is_the_one_of_the_processor() {
        for (n, divisor) in numbers().zip(numbers().skip(7)) {
            for divisor in [divisor, divisor >> 32, !0, 1 << 31, 1, 0xFFFF_0000] {
                let Some(divisor) = NonZero::new(divisor as u32) else {
                    continue;
                };
                let (quotient, remainder) = (n / divisor.get() as u64, n % divisor.get() as u64);
                let expected = u32::try_from(quotient).ok().map(|q| (q, remainder as u32));
                assert_eq!(divide_u64(n, divisor), expected, "{n} / {divisor}");
            }
        }
    }
}
