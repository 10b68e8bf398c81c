//! The gravity scene with linear drag, solved exactly.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use fixstep::{ExactDrag, dec};
use fixstep_firmware::weigh;

#[entry]
fn main() -> ! {
    weigh::end(weigh::force(|_| ExactDrag::new(dec!(0.05))))
}
