//! The number law for numbers drawn at random, which shrink to the simplest that breaks it.

use fixstep::fixed::types::{I8F24, I12F20, I16F16, I32F32};
use proptest::prelude::*;

use crate::laws::float::Floats;
use crate::laws::integer::Integers;
use crate::laws::judge::{self, Factors};

fn config() -> ProptestConfig {
    ProptestConfig {
        failure_persistence: None,
        ..ProptestConfig::with_cases(512)
    }
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn fixed_point_of_32_bits(a: i32, b: i32) {
        judge::pair::<I16F16, Integers>(I16F16::from_bits(a), I16F16::from_bits(b));
        judge::pair::<I8F24, Integers>(I8F24::from_bits(a), I8F24::from_bits(b));
        judge::value::<I12F20, Integers>(I12F20::from_bits(a), &Factors::some::<Integers>());
    }

    #[test]
    fn fixed_point_of_64_bits(a: i64, b: i64) {
        judge::pair::<I32F32, Integers>(I32F32::from_bits(a), I32F32::from_bits(b));
        judge::value::<I32F32, Integers>(I32F32::from_bits(a), &Factors::some::<Integers>());
    }

    #[test]
    fn floats(a in prop::num::f32::ANY, b in prop::num::f32::ANY) {
        judge::pair::<f32, Floats>(a, b);
        judge::value::<f32, Floats>(a, &Factors::some::<Floats>());
    }
}
