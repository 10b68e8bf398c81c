//! The gravity scene with quadratic drag.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use fixstep::{QuadraticDrag, dec};
use fixstep_firmware::weigh;

#[entry]
fn main() -> ! {
    weigh::end(weigh::force(|_| QuadraticDrag::new(dec!(0.05))))
}
