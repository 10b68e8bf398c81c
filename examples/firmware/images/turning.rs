//! Every verb of bodies that turn and of their shapes in one image: it links only if none of them can panic.
#![no_std]
#![no_main]

use measure::Priced;
use measure::scenes::{Meter, every_turning};

board::image!(|board| {
    Priced::new(board).whole("every turning verb", every_turning::hash());
    Ok(())
});
