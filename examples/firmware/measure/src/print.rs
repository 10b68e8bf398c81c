//! Words and numbers to the host, without the formatting code of `core`.

use crate::board::Board;

/// Prints by way of a board.
pub struct Printer<'a, B>(pub &'a B);

impl<B: Board> Printer<'_, B> {
    /// Prints text.
    pub fn text(&self, text: &str) {
        self.0.print(text);
    }

    /// Prints a number in the given base, 10 or 16.
    pub fn number(&self, mut value: u64, base: u64) {
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
        let (_, written) = digits.split_at_checked(20 - used).unwrap_or((&[], &[]));
        self.text(core::str::from_utf8(written).unwrap_or("?"));
    }

    /// Prints a number of tenths with its point.
    pub fn tenths(&self, value: u64) {
        self.number(value / 10, 10);
        self.text(".");
        self.number(value % 10, 10);
    }
}
