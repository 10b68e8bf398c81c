//! Every verb of exact drags and springs, of bodies that carry and of methods of order 4: links only
//! if none of them can panic.
#![no_std]
#![no_main]

use measure::Priced;
use measure::scenes::{Meter, every_exact};

board::image!(|board| {
    Priced::new(board).whole("every exact verb", every_exact::hash());
    Ok(())
});
