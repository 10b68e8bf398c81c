//! Root and quotient of a number of 64 bits bit by bit, for ARM cores that cannot divide.
//!
//! There a division of 32 bits is a call that goes bit by bit as well, and `division.rs` makes two of
//! them. A quotient of few digits takes few rounds here; one of thirty is cheaper there.

use core::num::NonZero;

/// What `division.rs` says: the root of `n 2^up`, rounded down, and an even `up`; zero for zero.
pub(in crate::scalar) fn root_u64(n: u64) -> (u32, u32) {
    let (high, low, words) = match (n >> 32) as u32 {
        0 => (n as u32, 0, 32),
        high => (high, n as u32, 0),
    };
    if high == 0 {
        return (0, 0);
    }
    let up = high.leading_zeros() & 30;
    let (high, mut low) = (high << up | low >> 1 >> (31 - up), low << up);
    let (mut root, mut remainder) = (1_u32 << 15, high.wrapping_sub(1 << 30));
    for place in (0..15).rev() {
        let more = (root << 1 | 1 << place) << place;
        if remainder >= more {
            remainder -= more;
            root |= 1 << place;
        }
    }
    // From here on two bits of n for one of the root. What is left is at most twice the root.
    let mut remainder = remainder as u64;
    for _ in 0..16 {
        remainder = remainder << 2 | (low >> 30) as u64;
        let more = (root as u64) << 2 | 1;
        (low, root) = (low << 2, root << 1);
        if remainder >= more {
            remainder -= more;
            root |= 1;
        }
    }
    (root, words + up)
}

/// Quotient and remainder for a divisor below `2^31`; `None` where the quotient does not fit.
pub(in crate::scalar) fn divide_short(n: u64, divisor: NonZero<u32>) -> Option<(u32, u32)> {
    let (mut remainder, mut low, mut bits) = ((n >> 32) as u32, n as u32, 32);
    if remainder >= divisor.get() {
        return None;
    }
    while bits > 8 && remainder < divisor.get() >> 8 {
        (remainder, low, bits) = (remainder << 8 | low >> 24, low << 8, bits - 8);
    }
    while bits > 0 {
        (remainder, low, bits) = (remainder << 1 | low >> 31, low << 1, bits - 1);
        if remainder >= divisor.get() {
            (remainder, low) = (remainder - divisor.get(), low + 1);
        }
    }
    Some((low, remainder))
}

#[cfg(test)]
mod tests {
    use super::super::division;
    use super::*;

    /// Numbers of every length.
    fn numbers() -> impl Iterator<Item = u64> {
        let mut seed = 1_u64;
        (0..200_000).map(move |i| {
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (seed ^ seed >> 32) >> (i & 63)
        })
    }

    #[test]
    fn root_is_that_of_digits() {
        for n in numbers() {
            for n in [n, n & !0 << 32, (n >> 32) * (n >> 32)] {
                for n in [n.wrapping_sub(1), n, n.wrapping_add(1)] {
                    assert_eq!(root_u64(n), division::root_u64(n), "{n}");
                }
            }
        }
    }

    #[test]
    fn quotient_is_that_of_digits() {
        for (n, divisor) in numbers().zip(numbers().skip(7)) {
            for divisor in [divisor, divisor >> 33, 1, 255, 256, (1 << 31) - 1, 1 << 30] {
                let Some(divisor) = NonZero::new(divisor as u32 & i32::MAX as u32) else {
                    continue;
                };
                let expected = division::divide_u64(n, divisor);
                assert_eq!(divide_short(n, divisor), expected, "{n} / {divisor}");
            }
        }
    }
}
