//! The gravity scene with quadratic drag, solved exactly.
#![no_std]
#![no_main]

use fixstep::{ExactQuadraticDrag, dec};
use measure::weigh;

board::image!(|_| weigh::force(|_| ExactQuadraticDrag::new(dec!(0.05)), 600));
