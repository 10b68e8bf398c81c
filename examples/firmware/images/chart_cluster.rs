//! Prices the charts' scene `cluster`.
#![no_std]
#![no_main]

use measure::Priced;
use measure::scenes::chart;

board::image!(|board| chart::show::<chart::Cluster>(&mut Priced::new(board)));
