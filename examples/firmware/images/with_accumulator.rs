//! The gravity scene with its steps counted out by a clock of microseconds.
#![no_std]
#![no_main]

use core::hint::black_box;

use fixstep::{Accumulator, dec};
use measure::weigh;

board::image!(|_| weigh::steps(
    || {
        let mut clock = Accumulator::new(1_000_000, dec!(0.015625), 600)?;
        Ok(clock.advance(black_box(10_000_000)).steps)
    },
    |_| (),
));
