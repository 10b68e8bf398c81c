//! What the charts' scene `projectile` costs.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use fixstep_firmware::scenes::Projectile;
use fixstep_firmware::{chart, count, print};

#[entry]
fn main() -> ! {
    count::start();
    match chart::price::<Projectile>() {
        Ok(()) => print::exit(),
        Err(_) => print::fail("a constructor refused a value\n"),
    }
}
