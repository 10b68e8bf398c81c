//! The gravity scene with bodies that turn.
#![no_std]
#![no_main]

use fixstep::{Rigid, SemiImplicitEuler};
use measure::weigh::{self, Ball};

board::image!(|_| weigh::method::<Rigid<Ball>>(SemiImplicitEuler));
