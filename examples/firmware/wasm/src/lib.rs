//! A host that imports two functions, `print` and `exit`, such as `run.mjs` in node. Nothing is counted.
#![no_std]

pub use measure;
use measure::{Board, Counts};

/// The board.
pub struct This;

#[link(wasm_import_module = "host")]
unsafe extern "C" {
    fn print(text: *const u8, length: usize);
    fn exit(code: u32) -> !;
}

// SAFETY: no stack is told.
unsafe impl Board for This {
    const COUNTS: Counts = Counts::Nothing;
    const ROUND: u32 = 0;

    fn start(&self) {}

    fn ticks(&self) -> u32 {
        0
    }

    fn spin(&self, _: u32) {}

    fn print(&self, text: &str) {
        // SAFETY: the host reads a string.
        unsafe { print(text.as_ptr(), text.len()) };
    }

    fn exit(&self, ok: bool) -> ! {
        // SAFETY: the host ends the process.
        unsafe { exit(!ok as u32) }
    }

    fn stack_bottom(&self) -> Option<usize> {
        None
    }
}

/// The entry of an image, which is handed the board.
#[macro_export]
macro_rules! image {
    ($image:expr) => {
        #[unsafe(no_mangle)]
        extern "C" fn run() {
            $crate::measure::finish(&$crate::This, $image)
        }
    };
}
