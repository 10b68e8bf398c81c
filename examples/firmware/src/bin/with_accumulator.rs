//! The gravity scene with its steps counted out by a clock of microseconds.
#![no_std]
#![no_main]

use core::hint::black_box;

use cortex_m_rt::entry;
use fixstep::{Accumulator, dec};
use fixstep_firmware::weigh;

#[entry]
fn main() -> ! {
    weigh::end(weigh::steps(
        || {
            let mut clock = Accumulator::new(1_000_000, dec!(0.015625), 600)?;
            Ok(clock.advance(black_box(10_000_000)).steps)
        },
        |_| (),
    ))
}
