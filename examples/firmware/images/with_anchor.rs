//! The gravity scene with a spring from one of its points to a place.
#![no_std]
#![no_main]

use fixstep::{Anchor, dec, vec2};
use measure::weigh;

board::image!(|_| weigh::force(
    |[first, _]| Anchor::new(first, vec2(0, 0)?, 40, dec!(0.5)),
    600
));
