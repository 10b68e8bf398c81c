//! Every verb of the crate in one image: it links only if none of them can panic. Prints a hash.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use fixstep_firmware::{every_verb, print};

#[entry]
fn main() -> ! {
    match every_verb::hash() {
        Ok(hash) => print::number(hash, 16),
        Err(_) => print::fail("a constructor refused a value\n"),
    }
    print::text("\n");
    print::exit()
}
