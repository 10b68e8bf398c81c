//! What both Cortex-M boards do alike: loops of known length, printing and exit by semihosting, the bottom of the stack.

use cortex_m_semihosting::{debug, hio};

/// A loop of two instructions a round.
#[inline(always)]
pub fn spin(rounds: u32) {
    // SAFETY: it changes one register, which is its own.
    unsafe {
        core::arch::asm!(
            "adds {0}, #1",
            "2: subs {0}, #1",
            "bne 2b",
            inout(reg) rounds => _,
        );
    }
}

#[inline(always)]
pub fn print(text: &str) {
    if let Ok(mut out) = hio::hstdout() {
        let _ = out.write_all(text.as_bytes());
    }
}

#[inline(always)]
pub fn exit(ok: bool) -> ! {
    debug::exit(if ok {
        debug::EXIT_SUCCESS
    } else {
        debug::EXIT_FAILURE
    });
    loop {}
}

#[inline(always)]
pub fn stack_bottom() -> Option<usize> {
    unsafe extern "C" {
        static __sheap: u32;
    }
    Some(&raw const __sheap as usize)
}
