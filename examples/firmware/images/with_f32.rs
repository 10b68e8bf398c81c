//! The gravity scene in `f32`.
#![no_std]
#![no_main]

use fixstep::{Point, SemiImplicitEuler};
use measure::weigh;

board::image!(|_| weigh::method::<Point<f32>>(SemiImplicitEuler));
