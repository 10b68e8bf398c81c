//! What all images share: the scenes, which are those of the host's tests, what is measured of them,
//! and a panic handler that cannot link.
#![no_std]

mod board;
mod meter;
mod print;
#[path = "../../../../tests/firmware/scenes/mod.rs"]
pub mod scenes;
mod stack;
pub mod weigh;

pub use board::{Board, Counts, finish};
pub use meter::Priced;
pub use print::Printer;

/// Defined nowhere: an image in which a panic is possible does not link.
#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    unsafe extern "C" {
        fn a_panic_is_possible() -> !;
    }
    // SAFETY: there is no such function, and so no such image.
    unsafe { a_panic_is_possible() }
}
