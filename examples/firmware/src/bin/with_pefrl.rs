//! The gravity scene by the method PEFRL.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use fixstep::Pefrl;
use fixstep_firmware::weigh;

#[entry]
fn main() -> ! {
    weigh::end(weigh::method::<weigh::Ball>(Pefrl::new()))
}
