//! The gravity scene by the method PEFRL.
#![no_std]
#![no_main]

use fixstep::Pefrl;
use measure::weigh;

board::image!(|_| weigh::method::<weigh::Ball>(Pefrl::new()));
