//! Trails that fade. A pixel of the bitmap holds the group of what is there and the slot of the picture
//! that drew it; when that slot comes next, it is wiped, unless something newer is there.

use core::cell::UnsafeCell;

use gba::prelude::*;

use crate::colors::{self, AGES};
use crate::scene::Place;

/// Whose world it is.
#[derive(Clone, Copy)]
pub enum Who {
    Fixed,
    Float,
}

/// What is drawn.
#[derive(Clone, Copy)]
enum Kind {
    Body,
    Line,
}

/// Pictures that share a slot, and pixels that they may draw.
const SHARE: u32 = 2;
const PIXELS: usize = 1024;
const WIDTH: i32 = 240;
/// The rows between the lines of the frame.
pub const ROWS: core::ops::Range<i32> = 12..132;
/// Pictures between two rows of words.
const REPORT: u32 = 4;

/// What each of the last pictures drew, and the picture that is drawn now.
pub struct Canvas {
    drawn: [[u16; PIXELS]; AGES],
    used: [u16; AGES],
    slot: usize,
    count: u32,
}

/// 80 KiB, so in the large RAM.
struct Shared(UnsafeCell<Canvas>);

// SAFETY: there is one thread, and no interrupt touches it.
unsafe impl Sync for Shared {}

#[unsafe(link_section = ".noinit.canvas")]
static CANVAS: Shared = Shared(UnsafeCell::new(Canvas {
    drawn: [[0; PIXELS]; AGES],
    used: [0; AGES],
    slot: 0,
    count: 0,
}));

impl Canvas {
    /// The canvas; `main` clears it, since nothing else does.
    ///
    /// # Safety
    ///
    /// To be asked for once: there is one.
    pub unsafe fn take() -> &'static mut Canvas {
        // SAFETY: nobody else has it.
        unsafe { &mut *CANVAS.0.get() }
    }

    /// Black, without a past.
    pub fn clear(&mut self) {
        (self.used, self.slot, self.count) = ([0; AGES], 0, 0);
        for y in ROWS {
            for x in 0..WIDTH as usize / 2 {
                if let Some(pair) = pair(x, y as usize) {
                    pair.write(u8x2::default());
                }
            }
        }
    }

    /// Begins a picture: what is oldest goes, the rest fades.
    pub fn next(&mut self) {
        self.count = self.count.wrapping_add(1);
        let part = self.count % SHARE;
        if part == 0 {
            self.slot = after(self.slot);
            colors::fade(self.slot);
        }
        self.wipe(after(self.slot), part + 1 == SHARE);
    }

    /// The row of words that is to be written in this picture: one at a time, since they take long.
    pub fn row_that_is_due(&self) -> Option<usize> {
        let row = self.count / REPORT % 4;
        (self.count % REPORT == 1).then_some(row as usize)
    }

    /// Wipes half of a slot: in each picture one, as all takes long.
    #[inline(never)]
    #[instruction_set(arm::a32)]
    #[unsafe(link_section = ".iwram.wipe")]
    fn wipe(&mut self, slot: usize, rest: bool) {
        let (Some(drawn), Some(used)) = (self.drawn.get(slot), self.used.get_mut(slot)) else {
            return;
        };
        let half = *used as usize / 2;
        let (from, count) = if rest { (half, PIXELS) } else { (0, half) };
        for &place in drawn.iter().take(*used as usize).skip(from).take(count) {
            let (x, y) = (place & 0xFF, place >> 8);
            change(x as usize, y as usize, |old| {
                let mut of_slot = slot + 1;
                while of_slot < old as usize {
                    of_slot += AGES;
                }
                if of_slot == old as usize { 0 } else { old }
            });
        }
        if rest {
            *used = 0;
        }
    }

    /// A body: five pixels.
    #[inline(never)]
    #[instruction_set(arm::a32)]
    #[unsafe(link_section = ".iwram.dot")]
    pub fn dot(&mut self, who: Who, place: Place) {
        let Some(mut pen) = self.pen(Kind::Body, who) else {
            return;
        };
        for [x, y] in [[0, -1], [-1, 0], [0, 0], [1, 0], [0, 1]] {
            pen.plot(place.x + x, place.y + y);
        }
    }

    /// A straight line: as many pixels as it is long in its longer direction, by sums with a fraction of
    /// 16 bits.
    #[inline(never)]
    #[instruction_set(arm::a32)]
    #[unsafe(link_section = ".iwram.line")]
    pub fn line(&mut self, who: Who, from: Place, to: Place) {
        let (dx, dy) = (to.x - from.x, to.y - from.y);
        let pixels = dx.abs().max(dy.abs()).min(WIDTH);
        let (Some(inverse), Some(mut pen)) =
            ((1_i32 << 16).checked_div(pixels), self.pen(Kind::Line, who))
        else {
            return;
        };
        let (mut x, mut y) = ((from.x << 16) + (1 << 15), (from.y << 16) + (1 << 15));
        for _ in 0..pixels {
            pen.plot(x >> 16, y >> 16);
            x += dx * inverse;
            y += dy * inverse;
        }
    }

    #[inline(always)]
    fn pen(&mut self, kind: Kind, who: Who) -> Option<Pen<'_>> {
        let first = (1 + self.slot + 3 * AGES * kind as usize) as u8;
        let (own, other) = match who {
            Who::Fixed => (first, first + AGES as u8),
            Who::Float => (first + AGES as u8, first),
        };
        Some(Pen {
            own,
            other,
            both: first + 2 * AGES as u8,
            drawn: self.drawn.get_mut(self.slot)?,
            used: self.used.get_mut(self.slot)?,
        })
    }
}

/// The numbers that a pixel may get, and the list that it goes into.
struct Pen<'a> {
    own: u8,
    other: u8,
    both: u8,
    drawn: &'a mut [u16; PIXELS],
    used: &'a mut u16,
}

impl Pen<'_> {
    /// One pixel. Where the other world has drawn the same in this slot it becomes both's.
    #[inline(always)]
    fn plot(&mut self, x: i32, y: i32) {
        let Some(place) = self.drawn.get_mut(*self.used as usize) else {
            return;
        };
        if !(0..WIDTH).contains(&x) || !ROWS.contains(&y) {
            return;
        }
        let (own, other, both) = (self.own, self.other, self.both);
        change(x as usize, y as usize, |old| {
            if old == other || old == both {
                both
            } else {
                own
            }
        });
        *place = (y << 8 | x) as u16;
        *self.used += 1;
    }
}

fn after(slot: usize) -> usize {
    if slot + 1 < AGES { slot + 1 } else { 0 }
}

/// Two pixels side by side: the screen's memory takes no single byte.
#[inline(always)]
fn pair(x: usize, y: usize) -> Option<VolAddress<u8x2, Safe, Safe>> {
    VIDEO4_VRAM.get_frame(0)?.get(x, y)
}

/// Changes one pixel.
#[inline(always)]
pub fn change(x: usize, y: usize, to: impl FnOnce(u8) -> u8) {
    if let Some(pair) = pair(x / 2, y) {
        let old = pair.read();
        pair.write(if x % 2 == 0 {
            old.with_low(to(old.low()))
        } else {
            old.with_high(to(old.high()))
        });
    }
}
