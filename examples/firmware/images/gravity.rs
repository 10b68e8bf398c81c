//! The gravity scene and nothing else: what it adds to `empty` is what it costs in flash.
#![no_std]
#![no_main]

use fixstep::SemiImplicitEuler;
use measure::weigh::{self, Ball};

board::image!(|_| weigh::method::<Ball>(SemiImplicitEuler));
