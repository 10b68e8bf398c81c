//! The gravity scene by the method of Verlet.
#![no_std]
#![no_main]

use fixstep::Verlet;
use measure::weigh;

board::image!(|_| weigh::method::<weigh::Ball>(Verlet));
