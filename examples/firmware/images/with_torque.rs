//! The gravity scene with bodies that turn, a motor and bearings.
#![no_std]
#![no_main]

use fixstep::dec;
use fixstep::fixed::types::I16F16;
use fixstep::rigid::torque::{SpinDrag, Torque};
use measure::weigh;

board::image!(|_| weigh::turning(|[body, _]| {
    let torque = I16F16::ONE;
    Ok((Torque { body, torque }, SpinDrag::new(dec!(0.1))?))
}));
