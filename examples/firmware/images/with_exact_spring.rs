//! The gravity scene with an exact spring on one of its points.
#![no_std]
#![no_main]

use fixstep::{ExactSpring, dec, vec2};
use measure::weigh;

board::image!(|_| weigh::force(
    |[first, _]| ExactSpring::new(first, vec2(0, 0)?, 2, dec!(0.1)),
    600
));
