//! Prices the charts' scene `spring`.
#![no_std]
#![no_main]

use measure::Priced;
use measure::scenes::chart;

board::image!(|board| chart::show::<chart::Springs>(&mut Priced::new(board)));
