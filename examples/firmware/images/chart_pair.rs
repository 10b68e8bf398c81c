//! Prices the charts' scene `pair`.
#![no_std]
#![no_main]

use measure::Priced;
use measure::scenes::chart;

board::image!(|board| chart::show::<chart::Pair>(&mut Priced::new(board)));
