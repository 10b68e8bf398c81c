//! Prices the charts' scene `kepler`.
#![no_std]
#![no_main]

use measure::Priced;
use measure::scenes::chart;

board::image!(|board| chart::show::<chart::Kepler>(&mut Priced::new(board)));
