//! The `virt` machine of QEMU (RV32IMAC): its UART, its power switch, and `minstret`, which counts
//! instructions.
#![no_std]

pub use measure;
use measure::{Board, Counts};
pub use riscv_rt;

/// The board.
pub struct This;

const UART: *mut u8 = 0x1000_0000 as *mut u8;
const SWITCH: *mut u32 = 0x0010_0000 as *mut u32;

// SAFETY: below the stack of `riscv-rt` lies a heap of no bytes, and no interrupt is switched on.
unsafe impl Board for This {
    const COUNTS: Counts = Counts::Instructions;
    const ROUND: u32 = 2;

    fn start(&self) {}

    #[inline(never)]
    fn ticks(&self) -> u32 {
        let count: u32;
        // SAFETY: it reads a register.
        unsafe { core::arch::asm!("csrr {}, minstret", out(reg) count) };
        count
    }

    #[inline(never)]
    fn spin(&self, rounds: u32) {
        // SAFETY: it changes one register, which is its own.
        unsafe {
            core::arch::asm!(
                "addi {0}, {0}, 1",
                "2: addi {0}, {0}, -1",
                "bnez {0}, 2b",
                inout(reg) rounds => _,
            );
        }
    }

    fn print(&self, text: &str) {
        for byte in text.bytes() {
            // SAFETY: the sending register of the UART.
            unsafe { UART.write_volatile(byte) };
        }
    }

    fn exit(&self, ok: bool) -> ! {
        // SAFETY: the register that ends the emulation.
        unsafe { SWITCH.write_volatile(if ok { 0x5555 } else { 0x1_3333 }) };
        loop {}
    }

    fn stack_bottom(&self) -> Option<usize> {
        unsafe extern "C" {
            static __sheap: u32;
        }
        Some(&raw const __sheap as usize)
    }
}

/// The entry of an image, which is handed the board.
#[macro_export]
macro_rules! image {
    ($image:expr) => {
        #[$crate::riscv_rt::entry]
        fn main() -> ! {
            $crate::measure::finish(&$crate::This, $image)
        }
    };
}
