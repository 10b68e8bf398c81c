//! The gravity scene with bodies that turn, two of them on a spring off their centres.
#![no_std]
#![no_main]

use fixstep::rigid::torque::Attached;
use fixstep::{Pairs, Spring, dec, vec2};
use measure::weigh;

board::image!(|_| weigh::turning(|pair| {
    let spring = Spring::new(2, 40, dec!(0.5))?;
    let at = [vec2(1, 0)?, vec2(0, dec!(0.5))?];
    Ok(Pairs::new(Attached { spring, at }, [pair]))
}));
