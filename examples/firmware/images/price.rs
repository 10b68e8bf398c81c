//! Prices the gravity scene.
#![no_std]
#![no_main]

use measure::{Priced, scenes};

board::image!(|board| scenes::gravity::show(&mut Priced::new(board)));
