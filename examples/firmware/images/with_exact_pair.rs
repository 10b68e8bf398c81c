//! The gravity scene with an exact spring between two of its points.
#![no_std]
#![no_main]

use fixstep::{ExactPair, dec, vec2};
use measure::weigh;

board::image!(|_| weigh::force(|pair| ExactPair::new(pair, vec2(2, 0)?, 2, dec!(0.1)), 600));
