//! The gravity scene with linear drag, solved exactly.
#![no_std]
#![no_main]

use fixstep::{ExactDrag, dec};
use measure::weigh;

board::image!(|_| weigh::force(|_| ExactDrag::new(dec!(0.05)), 600));
