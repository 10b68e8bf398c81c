//! What the charts' scene `kepler` costs.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use fixstep_firmware::scenes::Kepler;
use fixstep_firmware::{chart, count, print};

#[entry]
fn main() -> ! {
    count::start();
    match chart::price::<Kepler>() {
        Ok(()) => print::exit(),
        Err(_) => print::fail("a constructor refused a value\n"),
    }
}
