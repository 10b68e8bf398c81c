//! Start-up and exit: the floor that the others are weighed against.
#![no_std]
#![no_main]

use core::hint::black_box;

board::image!(|_| black_box(Ok(())));
