//! Prices bodies that turn.
#![no_std]
#![no_main]

use measure::{Priced, scenes};

board::image!(|board| scenes::rigid::show(&mut Priced::new(board)));
