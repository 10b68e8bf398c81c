//! Start-up, printer and exit: the floor that `gravity` is weighed against.
#![no_std]
#![no_main]

use core::hint::black_box;

use cortex_m_rt::entry;
use fixstep_firmware::print;

#[entry]
fn main() -> ! {
    print::number(black_box(0), 16);
    print::exit()
}
