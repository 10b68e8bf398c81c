//! Prices the charts' scene `projectile`.
#![no_std]
#![no_main]

use measure::Priced;
use measure::scenes::chart;

board::image!(|board| chart::show::<chart::Projectile>(&mut Priced::new(board)));
