//! The MPS2 board AN386 of QEMU (Cortex-M4F): semihosting, and the CMSDK's timer 0. With
//! `-icount shift=6` an instruction takes 64 ns, whatever the host does.
#![no_std]

#[path = "../../cortex.rs"]
mod cortex;

pub use cortex_m_rt;
pub use measure;
use measure::{Board, Counts};

/// The board.
pub struct This;

/// A tick, at 25 MHz, and an instruction, in ns.
const TICK: u64 = 40;
const INSTRUCTION: u64 = 64;

/// RELOAD, VALUE, CTRL enable: it counts down.
const START: [(usize, u32); 3] = [(0x4000_0008, u32::MAX), (VALUE, u32::MAX), (0x4000_0000, 1)];
const VALUE: usize = 0x4000_0004;

// SAFETY: below the stack of `cortex-m-rt` lies memory that no one uses, and no interrupt is switched on.
unsafe impl Board for This {
    const COUNTS: Counts = Counts::Instructions;
    const ROUND: u32 = 2;

    fn start(&self) {
        for (address, value) in START {
            // SAFETY: registers of the timer.
            unsafe { core::ptr::write_volatile(address as *mut u32, value) };
        }
    }

    #[inline(never)]
    fn ticks(&self) -> u32 {
        // SAFETY: a register of the timer.
        u32::MAX - unsafe { core::ptr::read_volatile(VALUE as *const u32) }
    }

    fn counts(&self, ticks: u32) -> u32 {
        (ticks as u64 * TICK / INSTRUCTION) as u32
    }

    #[inline(never)]
    fn spin(&self, rounds: u32) {
        cortex::spin(rounds);
    }

    fn print(&self, text: &str) {
        cortex::print(text);
    }

    fn exit(&self, ok: bool) -> ! {
        cortex::exit(ok)
    }

    fn stack_bottom(&self) -> Option<usize> {
        cortex::stack_bottom()
    }
}

/// The entry of an image, which is handed the board.
#[macro_export]
macro_rules! image {
    ($image:expr) => {
        #[$crate::cortex_m_rt::entry]
        fn main() -> ! {
            $crate::measure::finish(&$crate::This, $image)
        }
    };
}
