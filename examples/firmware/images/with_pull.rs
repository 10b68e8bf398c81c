//! The gravity scene with all its points drawn to each other.
#![no_std]
#![no_main]

use fixstep::{AllPairs, Pull, dec};
use measure::weigh;

board::image!(|_| weigh::force(|_| Ok(AllPairs(Pull::new(dec!(0.5), dec!(0.5))?)), 600));
