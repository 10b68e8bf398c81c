//! The gravity scene with bodies that keep remainders.
#![no_std]
#![no_main]

use fixstep::fixed::types::I16F16;
use fixstep::{Carried, SemiImplicitEuler};
use measure::weigh;

board::image!(|_| weigh::method::<Carried<I16F16>>(SemiImplicitEuler));
