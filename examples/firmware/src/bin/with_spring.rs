//! The gravity scene with a spring between two of its points.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use fixstep::{Pairs, Spring, dec};
use fixstep_firmware::weigh;

#[entry]
fn main() -> ! {
    weigh::end(weigh::force(|pair| {
        Ok(Pairs::new(Spring::new(2, 40, dec!(0.5))?, [pair]))
    }))
}
