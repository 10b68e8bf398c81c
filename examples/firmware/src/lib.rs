//! What the images share: the board's counter, a printer, and a panic handler that cannot link. The
//! scenes are those of the host's tests.
#![no_std]

pub mod chart;
pub mod count;
#[path = "../../../tests/firmware/every_exact.rs"]
pub mod every_exact;
#[path = "../../../tests/firmware/every_verb.rs"]
pub mod every_verb;
#[path = "../../../tests/firmware/force_scene.rs"]
pub mod force_scene;
pub mod print;
#[path = "../../../tests/firmware/scene.rs"]
pub mod scene;
#[path = "../../charts/scenes.rs"]
pub mod scenes;
pub mod weigh;

/// Defined nowhere: an image in which a panic is possible does not link.
#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    unsafe extern "C" {
        fn a_panic_is_possible() -> !;
    }
    unsafe { a_panic_is_possible() }
}
