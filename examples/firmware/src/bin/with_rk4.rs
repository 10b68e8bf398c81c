//! The gravity scene by the method of Runge and Kutta.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use fixstep::Rk4;
use fixstep_firmware::weigh;

#[entry]
fn main() -> ! {
    weigh::end(weigh::method::<weigh::Ball>(Rk4::new()))
}
