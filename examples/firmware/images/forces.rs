//! Prices each force, and what is done beside the steps.
#![no_std]
#![no_main]

use measure::{Priced, scenes};

board::image!(|board| scenes::force::show(&mut Priced::new(board)));
