//! Every verb of exact drags and springs, of bodies that carry and of methods of order 4: links only
//! if none of them can panic. Prints a hash.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use fixstep_firmware::{every_exact, print};

#[entry]
fn main() -> ! {
    match every_exact::hash() {
        Ok(hash) => print::number(hash, 16),
        Err(_) => print::fail("a constructor refused a value\n"),
    }
    print::text("\n");
    print::exit()
}
