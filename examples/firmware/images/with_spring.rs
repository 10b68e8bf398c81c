//! The gravity scene with a spring between two of its points.
#![no_std]
#![no_main]

use fixstep::{Pairs, Spring, dec};
use measure::weigh;

board::image!(|_| weigh::force(
    |pair| Ok(Pairs::new(Spring::new(2, 40, dec!(0.5))?, [pair])),
    600
));
