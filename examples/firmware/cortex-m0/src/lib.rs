//! The BBC micro:bit of QEMU (Cortex-M0, the instruction set of an M0+): semihosting, and Nordic's
//! TIMER0. With `-icount shift=6` an instruction takes 64 ns, whatever the host does.
#![no_std]

#[path = "../../cortex.rs"]
mod cortex;

pub use cortex_m_rt;
pub use measure;
use measure::{Board, Counts};

/// The board.
pub struct This;

/// Halves of a nanosecond in a tick, at 16 MHz, and in an instruction.
const TICK: u64 = 125;
const INSTRUCTION: u64 = 128;

/// MODE timer, BITMODE 32, PRESCALER 0, CLEAR, START.
const START: [(usize, u32); 5] = [
    (0x4000_8504, 0),
    (0x4000_8508, 3),
    (0x4000_8510, 0),
    (0x4000_800c, 1),
    (0x4000_8000, 1),
];

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
        // SAFETY: CAPTURE and CC of the timer.
        unsafe {
            core::ptr::write_volatile(0x4000_8040 as *mut u32, 1);
            core::ptr::read_volatile(0x4000_8540 as *const u32)
        }
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
