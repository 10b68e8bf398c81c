//! Sine and cosine of an angle in turns, in integers.
//!
//! ```text
//! a = q/4 + y/8              q the nearest quarter turn, -1 <= y <= 1;  z = y²
//! sin(π y/4) = y (s0 - z (s1 - z (s2 - z (s3 - z s4))))
//! cos(π y/4) = 1 - z (c1 - z (c2 - z (c3 - z c4)))
//! ```
//!
//! A quarter turn is a power of two, so the remainder is a shift of the angle, and exact. The coefficients
//! are those of the polynomials in z that agree with `sin(π y/4) / y` at the five zeros of the Chebyshev
//! polynomial on 0..1, and with `(1 - cos(π y/4)) / z` at the four: off by at most 0.004 and 0.21 units of 2^-30.
//! Then each was moved by a few of its own units, where that made the largest error of the integers less.
//!
//! All symmetries are exact. `z` is the same for y and -y. The factor of y is odd. So this product is never a
//! tie, and rounding half up is symmetric. At an eighth of a turn both polynomials give the same.

use core::ops::Neg;

use crate::scalar::integer::high_product_i32;

/// `[cos, sin]` of `angle / 2^32` turns, in units of 2^-30; each off by at most one.
#[inline]
pub(super) fn circle_u32(angle: u32) -> [i32; 2] {
    // In units of 2^-31, from -1 to just below 1; its square in units of 2^-30.
    let y = (angle << 2) as i32;
    let z = high_product_i32(y, y);
    // For the last terms 16 bits of z are enough: a product of 32 bits.
    let coarse = z >> 16;

    // A sum is in units four times finer than what z times it is taken from, but for shifts. The
    // last ones would not fit and are kept less 1: y s = y + y (s - 1), in units of 2^-31, and halved.
    let sum = 1_286_768_466 - ((coarse * 42_451) >> 6);
    let sum = 171_138_506 - (high_product_i32(z, sum) >> 7);
    let sum = 1_387_197_332 - high_product_i32(z, sum);
    let sum = (-921_707_871 - high_product_i32(z, sum)) | 1;
    let sin = (y + high_product_i32(y, sum) + 1) >> 1;

    let sum = 1_433_591_396 - ((coarse * 60_846) >> 6);
    let sum = 544_750_907 - (high_product_i32(z, sum) >> 5);
    let sum = -1_645_615_539 - high_product_i32(z, sum);
    let cos = ((1 << 31) - (z + high_product_i32(z, sum)) as u32) >> 1;

    turned([cos as i32, sin], angle.wrapping_add(1 << 29) >> 30)
}

/// `[cos, sin]` of `angle / 2^64` turns, in units of 2^-62; each off by at most one. The same cut and the
/// series itself, for references on a host.
pub(super) fn circle_u64(angle: u64) -> [i64; 2] {
    /// `π/4` in units of 2^-64.
    const EIGHTH: u128 = 0xC90F_DAA2_2168_C235;
    const ONE: u128 = 1 << 64;
    let rest = (angle << 2) as i64;
    let x = (rest.unsigned_abs() as u128 * EIGHTH) >> 63;
    let z = (x * x) >> 64;
    let (mut cos, mut sin) = (ONE, ONE);
    // A divisor that the compiler, too, sees is not zero.
    let over = |product: u128, divisor: u64| ((product >> 64) as u64 / divisor.max(1)) as u128;
    // Up to x^21 / 21! < 2^-72.
    for n in (2..=20).rev().step_by(2) {
        cos = ONE - over(z * cos, n * (n - 1));
        sin = ONE - over(z * sin, n * (n + 1));
    }
    let [cos, sin] = [cos, (x * sin) >> 64].map(|value| ((value + 2) >> 2) as i64);
    let sin = if rest < 0 { -sin } else { sin };
    turned([cos, sin], (angle.wrapping_add(1 << 61) >> 62) as u32)
}

/// A direction rotated by so many quarter turns.
#[inline(always)]
fn turned<T: Neg<Output = T>>([cos, sin]: [T; 2], quarters: u32) -> [T; 2] {
    match quarters & 3 {
        0 => [cos, sin],
        1 => [-sin, cos],
        2 => [-cos, -sin],
        _ => [sin, -cos],
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::TAU;

    use super::*;

    /// Every 1237th angle, and those within 200 of each 64th of a turn.
    fn angles() -> impl Iterator<Item = u32> {
        let borders = (0..64).flat_map(|n: u32| {
            let first = (n << 26).wrapping_sub(200);
            (0..=400).map(move |near| first.wrapping_add(near))
        });
        (0..=u32::MAX).step_by(1237).chain(borders)
    }

    fn random() -> impl Iterator<Item = u64> {
        core::iter::successors(Some(1_u64), |seed| {
            Some(
                seed.wrapping_mul(6_364_136_223_846_793_005)
                    .wrapping_add(1_442_695_040_888_963_407),
            )
        })
    }

    // Of the sine: half a unit for the last rounding, a quarter for the sum before it, which is odd in units of
    // 2^-32, 0.1 for those before that. Of the cosine: half a unit, 0.2 for the polynomial, 0.3 for z, which is
    // rounded down. A point is off the circle by at most 2 (cos, sin) · e <= 2 sqrt(2) units. The
    // reference is off by a part in 2^50.
    #[test]
    fn is_near_the_circle() {
        const ONE: f64 = (1 << 30) as f64;
        for angle in angles() {
            let [cos, sin] = circle_u32(angle).map(f64::from);
            let x = angle as i32 as f64 * (TAU / 4_294_967_296.0);
            let errors = [cos - ONE * libm::cos(x), sin - ONE * libm::sin(x)];
            assert!(
                errors.iter().all(|e| e.abs() <= 1.0),
                "{angle:#x} {errors:?}"
            );
            let off = (cos * cos + sin * sin) / ONE - ONE;
            assert!(off.abs() <= 2.83, "{angle:#x} {off}");
        }
    }

    #[test]
    fn quarters_are_exact() {
        let quarters = [0, 1, 2, 3].map(|quarter| circle_u32(quarter << 30));
        assert_eq!(
            quarters,
            [[1, 0], [0, 1], [-1, 0], [0, -1]].map(|point| point.map(|x| x << 30))
        );
        let quarters = [0, 1, 2, 3].map(|quarter| circle_u64(quarter << 62));
        assert_eq!(
            quarters,
            [[1, 0], [0, 1], [-1, 0], [0, -1]].map(|point| point.map(|x| x << 62))
        );
    }

    // A tie, if there were one, would be likely at multiples of high powers of two.
    #[test]
    fn mirrors_are_exact() {
        for angle in random()
            .take(1_000_000)
            .map(|n| (n >> 32) as u32)
            .chain((0..1 << 17).map(|n| n << 15))
            .chain(angles().step_by(7))
        {
            let [cos, sin] = circle_u32(angle);
            assert_eq!(circle_u32(angle.wrapping_neg()), [cos, -sin], "{angle:#x}");
            assert_eq!(
                circle_u32(0x8000_0000_u32.wrapping_sub(angle)),
                [-cos, sin],
                "{angle:#x}"
            );
            assert_eq!(
                circle_u32(0x4000_0000_u32.wrapping_sub(angle)),
                [sin, cos],
                "{angle:#x}"
            );
        }
    }

    /// `[cos, sin]` in units of 2^-112, by the series from 0 to half a turn, to x^40 / 40! < 2^-93.
    fn series(angle: u64) -> [i128; 2] {
        const MASK: i128 = (1 << 56) - 1;
        const PI: i128 = 0x3_243F_6A88_85A3_08D3_1319_8A2E_0370;
        // In digits of 56 bits; none of the numbers is above 12.
        let times = |a: i128, b: i128| {
            let (ah, al, bh, bl) = (a >> 56, a & MASK, b >> 56, b & MASK);
            ah * bh + ((ah * bl + al * bh + ((al * bl) >> 56)) >> 56)
        };
        let x = times(PI, (angle as i64 as i128) << 49);
        let (mut sums, mut term) = ([1 << 112, 0], 1 << 112);
        for n in 1..=40_i128 {
            term = times(term, x) / n;
            sums[n as usize & 1] += if n & 2 == 0 { term } else { -term };
        }
        sums
    }

    // Half a unit for the last rounding; before it two units of 2^-64 at most: of the cosine one for each of the last
    // division and its product, of the sine one for x and one for the product with it.
    #[test]
    fn long_angles_are_near_the_circle() {
        let near =
            (0..64_u64).flat_map(|n| [0, 1, u64::MAX].map(|near| (n << 58).wrapping_add(near)));
        for angle in random().take(30_000).chain(near) {
            let expected = series(angle);
            let found = circle_u64(angle).map(|x| (x as i128) << 50);
            let errors = [found[0] - expected[0], found[1] - expected[1]];
            assert!(
                errors.iter().all(|e| e.abs() <= 1 << 50),
                "{angle:#x} {errors:?}"
            );
        }
    }

    #[test]
    fn long_mirrors_are_exact() {
        for angle in random().take(100_000).chain((0..64).map(|n| n << 58)) {
            let [cos, sin] = circle_u64(angle);
            assert_eq!(circle_u64(angle.wrapping_neg()), [cos, -sin], "{angle:#x}");
            assert_eq!(
                circle_u64((1_u64 << 63).wrapping_sub(angle)),
                [-cos, sin],
                "{angle:#x}"
            );
            assert_eq!(
                circle_u64((1_u64 << 62).wrapping_sub(angle)),
                [sin, cos],
                "{angle:#x}"
            );
        }
    }
}
