//! Runs two small scenes for ten minutes each.
#![no_std]
#![no_main]

use measure::{Priced, scenes};

board::image!(|board| scenes::long::show(&mut Priced::new(board)));
