//! Prices the charts' scene `quadratic`.
#![no_std]
#![no_main]

use measure::Priced;
use measure::scenes::chart;

board::image!(|board| chart::show::<chart::QuadraticProjectile>(&mut Priced::new(board)));
