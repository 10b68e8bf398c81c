//! The gravity scene in `I8F24`.
#![no_std]
#![no_main]

use fixstep::fixed::types::I8F24;
use fixstep::{Point, SemiImplicitEuler};
use measure::weigh;

board::image!(|_| weigh::method::<Point<I8F24>>(SemiImplicitEuler));
