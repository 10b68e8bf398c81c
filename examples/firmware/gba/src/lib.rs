//! The Game Boy Advance as a board: cycles from timers 2 and 3, lines to mGBA's log, and a
//! step made for its long multiply.
#![no_std]

mod long;

use gba::prelude::*;
use measure::{Board, Counts};

pub use long::Long;
pub use measure;

/// The board.
pub struct This;

/// Bytes of a line that the log takes at once.
const LINE: u8 = 255;

// SAFETY: below the stack lies memory behind `.bss` that no one uses; images switch no interrupt on.
unsafe impl Board for This {
    const COUNTS: Counts = Counts::Cycles;
    const ROUND: u32 = 4;

    // Timer 3 counts the overflows of timer 2.
    fn start(&self) {
        let on = TimerControl::new().with_enabled(true);
        TIMER2_CONTROL.write(TimerControl::new());
        TIMER3_CONTROL.write(TimerControl::new());
        TIMER2_RELOAD.write(0);
        TIMER3_RELOAD.write(0);
        TIMER3_CONTROL.write(on.with_cascade(true));
        TIMER2_CONTROL.write(on);
    }

    // In one time whatever it reads: the upper half that belongs to a lower half close before an
    // overflow is the one read before, else the one read after.
    #[inline(never)]
    fn ticks(&self) -> u32 {
        let before = TIMER3_COUNT.read();
        let low = TIMER2_COUNT.read();
        let after = TIMER3_COUNT.read();
        let high = if low >> 15 == 1 { before } else { after };
        (high as u32) << 16 | low as u32
    }

    fn spin(&self, rounds: u32) {
        spin(rounds);
    }

    // A line goes out whole, at its end or where the log is full.
    fn print(&self, text: &str) {
        static USED: GbaCell<u8> = GbaCell::new(0);
        let mut used = USED.read();
        for &byte in text.as_bytes() {
            if byte == b'\n' || used == LINE {
                MGBA_LOG_SEND.write(MgbaMessageLevel::Info);
                used = 0;
            }
            if byte == b'\n' {
                continue;
            }
            if let Some(place) = MGBA_LOG_BUFFER.get(used as usize) {
                place.write(byte);
            }
            used += 1;
        }
        USED.write(used);
    }

    fn exit(&self, ok: bool) -> ! {
        self.print(if ok { "EXIT 0\n" } else { "EXIT 1\n" });
        loop {
            VBlankIntrWait();
        }
    }

    fn stack_bottom(&self) -> Option<usize> {
        unsafe extern "C" {
            static __bss_end: u32;
        }
        Some(&raw const __bss_end as usize)
    }
}

/// Two instructions a round, of one cycle and of three: as ARM code in fast RAM, where none waits.
#[inline(never)]
#[instruction_set(arm::a32)]
#[unsafe(link_section = ".iwram.spin")]
fn spin(rounds: u32) {
    // SAFETY: it changes one register, which is its own.
    unsafe {
        core::arch::asm!(
            "add {0}, {0}, #1",
            "2: subs {0}, {0}, #1",
            "bne 2b",
            inout(reg) rounds => _,
        );
    }
}

/// The entry of an image, which is handed the board.
#[macro_export]
macro_rules! image {
    ($image:expr) => {
        #[unsafe(no_mangle)]
        extern "C" fn main() -> ! {
            $crate::measure::finish(&$crate::This, $image)
        }
    };
}
