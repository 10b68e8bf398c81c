//! The gravity scene with quadratic drag.
#![no_std]
#![no_main]

use fixstep::{QuadraticDrag, dec};
use measure::weigh;

board::image!(|_| weigh::force(|_| QuadraticDrag::new(dec!(0.05)), 600));
