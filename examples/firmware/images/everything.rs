//! Every verb of the crate in one image: it links only if none of them can panic.
#![no_std]
#![no_main]

use measure::Priced;
use measure::scenes::{Meter, every_verb};

board::image!(|board| {
    Priced::new(board).whole("every verb", every_verb::hash());
    Ok(())
});
