//! The gravity scene by the method of Runge and Kutta.
#![no_std]
#![no_main]

use fixstep::Rk4;
use measure::weigh;

board::image!(|_| weigh::method::<weigh::Ball>(Rk4::new()));
