//! The gravity scene with all its points drawn to each other.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use fixstep::{AllPairs, Pull, dec};
use fixstep_firmware::weigh;

#[entry]
fn main() -> ! {
    weigh::end(weigh::force(|_| {
        Ok(AllPairs(Pull::new(dec!(0.5), dec!(0.5))?))
    }))
}
