//! The high word of a product, in the way each core has it.

/// The high word of a product, on cores with a long multiply.
#[cfg(not(all(target_arch = "arm", not(target_has_atomic = "32"))))]
#[inline(always)]
pub(in crate::scalar) fn high_product_i32(a: i32, b: i32) -> i32 {
    ((a as i64 * b as i64) >> 32) as i32
}

/// The same word from 16-bit halves, for ARM cores whose multiplier gives 32 bits (Cortex-M0+;
/// they are told by having no atomics). The runtime's multiply makes 64 bits.
#[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
#[inline(always)]
pub(in crate::scalar) fn high_product_i32(a: i32, b: i32) -> i32 {
    high_product_halves(a, b)
}

/// The whole product.
#[cfg(not(all(target_arch = "arm", not(target_has_atomic = "32"))))]
#[inline(always)]
pub(in crate::scalar) fn product_i32(a: i32, b: i32) -> i64 {
    a as i64 * b as i64
}

/// The whole product: its low word is what the multiplier gives.
#[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
#[inline(always)]
pub(in crate::scalar) fn product_i32(a: i32, b: i32) -> i64 {
    (high_product_halves(a, b) as i64) << 32 | a.wrapping_mul(b) as u32 as i64
}

/// The largest shift of a coefficient whose odd fraction [`rounded_sum_i32`] takes.
#[cfg(not(all(target_arch = "arm", not(target_has_atomic = "32"))))]
pub(in crate::scalar) const ODD_SHIFT: u32 = 62;

/// Of up to 31 bits 16 remain, and the one that makes it odd.
#[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
pub(in crate::scalar) const ODD_SHIFT: u32 = 48;

/// `sum + a b / 2^32`, the quotient rounded half up; wraps where it does not fit: SMMLAR on a Cortex-M4.
#[cfg(not(all(target_arch = "arm", not(target_has_atomic = "32"))))]
#[inline(always)]
pub(in crate::scalar) fn rounded_sum_i32(sum: i32, a: i32, b: i32) -> i32 {
    (((sum as i64) << 32).wrapping_add(product_i32(a, b) + (1 << 31)) >> 32) as i32
}

/// The same for a b whose lower half is 1: two short products instead of five.
#[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
#[inline(always)]
pub(in crate::scalar) fn rounded_sum_i32(sum: i32, a: i32, b: i32) -> i32 {
    rounded_sum_halves(sum, a, b)
}

/// With `b = B 2^16 + 1` and a half up, what is below `2^16` carries nothing: it is the lower half of a.
/// No sum wraps: `(2^16 - 1) B + a / 2^16 + 2^15` lies between `-2^31 + 2^15` and `2^31 - 2^15`.
#[cfg_attr(
    not(all(target_arch = "arm", not(target_has_atomic = "32"))),
    allow(dead_code)
)]
#[inline(always)]
fn rounded_sum_halves(sum: i32, a: i32, b: i32) -> i32 {
    let (a_high, a_low, b_high) = (a >> 16, a & 0xFFFF, b >> 16);
    let low = a_low.wrapping_mul(b_high).wrapping_add(a_high + (1 << 15));
    let high = a_high.wrapping_mul(b_high);
    sum.wrapping_add(high).wrapping_add(low >> 16)
}

/// `a b / 2^32`, rounded half up: with the sum it is added to, SMMLAR on a Cortex-M4.
#[inline(always)]
pub(in crate::scalar) fn rounded_product_i32(a: i32, b: i32) -> i32 {
    #[cfg(not(all(target_arch = "arm", not(target_has_atomic = "32"))))]
    return ((product_i32(a, b) + (1 << 31)) >> 32) as i32;
    #[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
    return high_product_halves(a, b).wrapping_add((a.wrapping_mul(b) as u32 >> 31) as i32);
}

#[inline(always)]
pub(in crate::scalar) fn high_product_i64(a: i64, b: i64) -> i64 {
    ((a as i128 * b as i128) >> 64) as i64
}

/// Schoolbook product of 16-bit halves. No sum wraps: a product of a signed and an unsigned half
/// lies between `-2^31 + 2^15` and `(2^15 - 1)(2^16 - 1)`, and what is added is below `2^16`.
#[cfg_attr(
    not(all(target_arch = "arm", not(target_has_atomic = "32"))),
    allow(dead_code)
)]
#[inline(always)]
fn high_product_halves(a: i32, b: i32) -> i32 {
    let (a_high, a_low) = (a >> 16, a & 0xFFFF);
    let (b_high, b_low) = (b >> 16, b & 0xFFFF);
    let low = ((a_low as u32).wrapping_mul(b_low as u32) >> 16) as i32;
    let mixed = a_high.wrapping_mul(b_low).wrapping_add(low);
    let other = b_high.wrapping_mul(a_low).wrapping_add(mixed & 0xFFFF);
    let high = a_high.wrapping_mul(b_high);
    high.wrapping_add(mixed >> 16).wrapping_add(other >> 16)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halves_give_the_high_word() {
        let corners = [
            i32::MIN,
            i32::MIN + 1,
            -65_537,
            -65_536,
            -65_535,
            -1,
            0,
            1,
            65_535,
            65_536,
            i32::MAX,
        ];
        let mut seed = 1_u64;
        let mut random = || {
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (seed >> 32) as i32
        };
        for _ in 0..1_000_000 {
            let (a, b) = (random(), random());
            assert_eq!(
                high_product_halves(a, b),
                ((a as i64 * b as i64) >> 32) as i32
            );
            let (sum, odd) = (random() >> 2, b & !0xFFFF | 1);
            assert_eq!(
                rounded_sum_halves(sum, a, odd),
                rounded_sum_i32(sum, a, odd)
            );
        }
        for a in corners {
            for b in corners {
                assert_eq!(
                    high_product_halves(a, b),
                    ((a as i64 * b as i64) >> 32) as i32
                );
                let odd = b & !0xFFFF | 1;
                assert_eq!(rounded_sum_halves(7, a, odd), rounded_sum_i32(7, a, odd));
            }
        }
    }
}
