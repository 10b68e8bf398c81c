//! The gravity scene with an exact spring on one of its points.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use fixstep::{ExactSpring, dec, vec2};
use fixstep_firmware::weigh;

#[entry]
fn main() -> ! {
    weigh::end(weigh::force(|[first, _]| {
        ExactSpring::new(first, vec2(0, 0)?, 2, dec!(0.1))
    }))
}
