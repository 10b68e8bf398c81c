//! The gravity scene with bodies that turn.
#![no_std]
#![no_main]

use measure::weigh;

board::image!(|_| weigh::turning(|_| Ok(())));
