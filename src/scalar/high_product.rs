//! The high word of a product, in the way each core has it.

/// The high word of a product, on cores with a long multiply.
#[cfg(not(all(target_arch = "arm", not(target_has_atomic = "32"))))]
#[inline(always)]
pub(super) fn high_product_i32(a: i32, b: i32) -> i32 {
    ((a as i64 * b as i64) >> 32) as i32
}

/// The same word from 16-bit halves, for ARM cores whose multiplier gives 32 bits (Cortex-M0+;
/// they are told by having no atomics). The runtime's multiply makes 64 bits.
#[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
#[inline(always)]
pub(super) fn high_product_i32(a: i32, b: i32) -> i32 {
    high_product_halves(a, b)
}

/// The whole product.
#[cfg(not(all(target_arch = "arm", not(target_has_atomic = "32"))))]
#[inline(always)]
pub(super) fn product_i32(a: i32, b: i32) -> i64 {
    a as i64 * b as i64
}

/// The whole product: its low word is what the multiplier gives.
#[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
#[inline(always)]
pub(super) fn product_i32(a: i32, b: i32) -> i64 {
    (high_product_halves(a, b) as i64) << 32 | a.wrapping_mul(b) as u32 as i64
}

#[inline(always)]
pub(super) fn high_product_i64(a: i64, b: i64) -> i64 {
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
        }
        for a in corners {
            for b in corners {
                assert_eq!(
                    high_product_halves(a, b),
                    ((a as i64 * b as i64) >> 32) as i32
                );
            }
        }
    }
}
