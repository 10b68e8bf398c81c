//! The gravity scene with linear drag.
#![no_std]
#![no_main]

use fixstep::{LinearDrag, dec};
use measure::weigh;

board::image!(|_| weigh::force(|_| LinearDrag::new(dec!(0.05)), 600));
