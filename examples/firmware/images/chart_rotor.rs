//! Prices the charts' scene `rotor`.
#![no_std]
#![no_main]

use measure::Priced;
use measure::scenes::chart;

board::image!(|board| chart::show::<chart::Rotor>(&mut Priced::new(board)));
