//! A small game: gravity, drag, a spring between two points, and a clock of microseconds.
#![no_std]
#![no_main]

use core::hint::black_box;

use fixstep::{Accumulator, LinearDrag, Pairs, Spring, dec};
use measure::weigh;

board::image!(|_| {
    let mut clock = Accumulator::new(1_000_000, dec!(0.015625), 600)?;
    let due = clock.advance(black_box(10_000_000)).steps;
    weigh::force(
        |pair| {
            let spring = Spring::new(2, 40, dec!(0.5))?;
            Ok((LinearDrag::new(dec!(0.05))?, Pairs::new(spring, [pair])))
        },
        due,
    )
});
