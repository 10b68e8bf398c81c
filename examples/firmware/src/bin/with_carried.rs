//! The gravity scene with bodies that keep remainders.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use fixstep::fixed::types::I16F16;
use fixstep::{Carried, SemiImplicitEuler};
use fixstep_firmware::weigh;

#[entry]
fn main() -> ! {
    weigh::end(weigh::method::<Carried<I16F16>>(SemiImplicitEuler))
}
