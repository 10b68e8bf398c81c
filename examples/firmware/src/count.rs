//! Executed instructions, from a hardware timer of the emulated board.
//!
//! QEMU with `-icount shift=6` lets 64 ns pass for each instruction, so a timer counts them.

/// Nanoseconds an instruction takes in QEMU.
const INSTRUCTION: u64 = 64;

/// Starts the timer.
pub fn start() {
    for (address, value) in board::START {
        unsafe { core::ptr::write_volatile(*address as *mut u32, *value) };
    }
}

/// Instructions since the start, of which reading takes a few.
#[inline(never)]
pub fn now() -> u32 {
    (board::ticks() as u64 * board::NANOSECONDS_2 / (2 * INSTRUCTION)) as u32
}

/// Counts `rounds` rounds of a loop of two instructions.
#[inline(never)]
pub fn loop_of(rounds: u32) -> u32 {
    let start = now();
    unsafe {
        core::arch::asm!(
            "adds {0}, #1",
            "2: subs {0}, #1",
            "bne 2b",
            inout(reg) rounds => _,
        );
    }
    now() - start
}

/// Nordic TIMER0 of the `microbit`: 16 MHz, counts up, read by capturing.
#[cfg(not(target_has_atomic = "32"))]
mod board {
    pub const NANOSECONDS_2: u64 = 125;
    /// MODE timer, BITMODE 32, PRESCALER 0, CLEAR, START.
    pub const START: &[(usize, u32)] = &[
        (0x4000_8504, 0),
        (0x4000_8508, 3),
        (0x4000_8510, 0),
        (0x4000_800c, 1),
        (0x4000_8000, 1),
    ];

    pub fn ticks() -> u32 {
        unsafe {
            core::ptr::write_volatile(0x4000_8040 as *mut u32, 1);
            core::ptr::read_volatile(0x4000_8540 as *const u32)
        }
    }
}

/// CMSDK timer 0 of the `mps2-an386`: 25 MHz, counts down.
#[cfg(target_has_atomic = "32")]
mod board {
    pub const NANOSECONDS_2: u64 = 80;
    /// RELOAD, VALUE, CTRL enable.
    pub const START: &[(usize, u32)] = &[
        (0x4000_0008, u32::MAX),
        (0x4000_0004, u32::MAX),
        (0x4000_0000, 1),
    ];

    pub fn ticks() -> u32 {
        u32::MAX - unsafe { core::ptr::read_volatile(0x4000_0004 as *const u32) }
    }
}
