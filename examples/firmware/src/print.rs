//! Words and numbers to the host, without the formatting code of `core`.

use cortex_m_semihosting::{debug, hio};

/// Prints text.
pub fn text(text: &str) {
    if let Ok(mut out) = hio::hstdout() {
        let _ = out.write_all(text.as_bytes());
    }
}

/// Prints a number in the given base, 10 or 16.
pub fn number(mut value: u64, base: u64) {
    let mut digits = [0_u8; 20];
    let mut used = 0;
    for digit in digits.iter_mut().rev() {
        let low = (value % base.max(2)) as u8;
        *digit = if low < 10 {
            b'0' + low
        } else {
            b'a' + low - 10
        };
        value /= base.max(2);
        used += 1;
        if value == 0 {
            break;
        }
    }
    for digit in digits.iter().skip(20 - used) {
        text(core::str::from_utf8(core::slice::from_ref(digit)).unwrap_or("?"));
    }
}

/// Prints a number of tenths with its point.
pub fn tenths(value: u64) {
    number(value / 10, 10);
    text(".");
    number(value % 10, 10);
}

/// Ends the emulation as failed.
pub fn fail(why: &str) -> ! {
    text(why);
    debug::exit(debug::EXIT_FAILURE);
    loop {}
}

/// Ends the emulation.
pub fn exit() -> ! {
    debug::exit(debug::EXIT_SUCCESS);
    loop {}
}
