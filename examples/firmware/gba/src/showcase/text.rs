//! Words and numbers: four rows of thirty characters in the font of the crate `gba`. What stands there
//! already is not drawn again.

use gba::builtin_art::CGA_8X8_THICK;

use crate::canvas::{self, ROWS};
use crate::colors::Ink;

/// Characters in a row.
const COLUMNS: usize = 30;
/// Where the rows are, from the top of the screen.
const TOPS: [usize; 4] = [1, 134, 143, 152];

/// What stands on the screen, and where the next character goes.
pub struct Text {
    shown: [[(u8, u8); COLUMNS]; 4],
    row: usize,
    column: usize,
    ink: Ink,
}

impl Text {
    pub fn new() -> Text {
        Text {
            shown: [[(0, 0); COLUMNS]; 4],
            row: 0,
            column: 0,
            ink: Ink::White,
        }
    }

    /// Goes to the start of a row.
    pub fn at(&mut self, row: usize, ink: Ink) -> &mut Text {
        (self.row, self.column, self.ink) = (row, 0, ink);
        self
    }

    /// Goes on in another color.
    pub fn ink(&mut self, ink: Ink) -> &mut Text {
        self.ink = ink;
        self
    }

    pub fn word(&mut self, word: &str) -> &mut Text {
        for &byte in word.as_bytes() {
            self.character(byte);
        }
        self
    }

    /// Blanks up to a column.
    pub fn tab(&mut self, column: usize) -> &mut Text {
        while self.column < column.min(COLUMNS) {
            self.character(b' ');
        }
        self
    }

    /// Blanks up to the end of the row.
    pub fn end(&mut self) {
        self.tab(COLUMNS);
    }

    /// A number, right-aligned.
    pub fn number(&mut self, value: u32, width: u32) -> &mut Text {
        self.digits(value, width, 1)
    }

    /// A number of tenths, the whole part right-aligned.
    pub fn tenths(&mut self, value: u32, width: u32) -> &mut Text {
        self.number(value / 10, width - 2).word(".");
        self.digits(value % 10, 1, 1)
    }

    /// A number of hundredths.
    pub fn hundredths(&mut self, value: u32) -> &mut Text {
        self.number(value / 100, 2).word(".");
        self.digits(value % 100, 2, 2)
    }

    /// A number of units of 2^-16, with four decimals.
    pub fn fraction(&mut self, value: u32) -> &mut Text {
        let (whole, rest) = (value >> 16, value & 0xFFFF);
        self.number(whole, 2).word(".");
        self.digits(rest * 10_000 >> 16, 4, 4)
    }

    /// At least `least` digits, with blanks before them to make `width`.
    fn digits(&mut self, mut value: u32, width: u32, least: u32) -> &mut Text {
        let mut digits = [b' '; 10];
        for (i, digit) in (0..).zip(digits.iter_mut().rev()) {
            if value > 0 || i < least {
                *digit = b'0' + (value % 10) as u8;
            }
            value /= 10;
        }
        let digits = digits
            .iter()
            .enumerate()
            .skip_while(|&(i, &digit)| digit == b' ' && i + (width as usize) < digits.len());
        for (_, &digit) in digits {
            self.character(digit);
        }
        self
    }

    fn character(&mut self, byte: u8) {
        let Some(shown) = self
            .shown
            .get_mut(self.row)
            .and_then(|row| row.get_mut(self.column))
        else {
            return;
        };
        let new = (byte, self.ink as u8);
        if *shown != new {
            *shown = new;
            draw(
                self.column * 8,
                TOPS.get(self.row).copied().unwrap_or(0),
                byte,
                self.ink,
            );
        }
        self.column += 1;
    }
}

/// Draws a character: a byte of the font is a row of it, its lowest bit at the left.
#[inline(never)]
#[instruction_set(arm::a32)]
#[unsafe(link_section = ".iwram.draw")]
fn draw(left: usize, top: usize, byte: u8, ink: Ink) {
    for y in 0..8 {
        let word = CGA_8X8_THICK
            .get(byte as usize * 2 + y / 4)
            .copied()
            .unwrap_or(0);
        let bits = word >> (y % 4 * 8);
        for x in 0..8 {
            let on = bits >> x & 1 == 1;
            canvas::change(left + x, top + y, |_| if on { ink as u8 } else { 0 });
        }
    }
}

/// The lines above and below the scene.
pub fn frame() {
    for y in [ROWS.start - 1, ROWS.end] {
        for x in 0..240 {
            canvas::change(x, y as usize, |_| Ink::Dark as u8);
        }
    }
}
