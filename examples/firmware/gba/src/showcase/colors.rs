//! The palette, which does the fading: a pixel says in which picture it was drawn, and each picture
//! gives these numbers other colors. No pixel is drawn twice in order to fade.
//!
//! ```text
//! 0            black
//! 1 + 40 g + s group g (a kind of thing by whom), drawn in slot s, which two pictures share
//! 241..        ink of words and frame
//! ```

use gba::prelude::*;

/// Slots: a trail lasts one less, 78 pictures.
pub const AGES: usize = 40;
/// Kinds of things times who is there: fixed point, `f32`, both.
pub const GROUPS: usize = 6;

/// Colors of words and lines that stay.
#[derive(Clone, Copy, PartialEq)]
pub enum Ink {
    White = 241,
    Fixed,
    Float,
    Grey,
    Dark,
}

const FIXED: [u32; 3] = [6, 26, 31];
const FLOAT: [u32; 3] = [31, 17, 3];
const BOTH: [u32; 3] = [31, 31, 31];

/// Each group's color when fresh, its brightness in percent and how long it is seen.
const FRESH: [([u32; 3], u32, u32); GROUPS] = [
    (FIXED, 100, AGES as u32),
    (FLOAT, 100, AGES as u32),
    (BOTH, 100, AGES as u32),
    (FIXED, 40, 14),
    (FLOAT, 40, 14),
    (BOTH, 34, 14),
];

/// The colors of each group by age: fading in the square of what is left, as light does to the eye.
static FADING: [[Color; AGES]; GROUPS] = {
    let mut all = [[Color::BLACK; AGES]; GROUPS];
    let mut group = 0;
    while group < GROUPS {
        let (fresh, percent, life) = FRESH[group];
        let mut age = 0;
        while age < life {
            let left = life - age;
            all[group][age as usize] = faded(fresh, percent, left, life);
            age += 1;
        }
        group += 1;
    }
    all
};

const fn faded(fresh: [u32; 3], percent: u32, left: u32, life: u32) -> Color {
    let (num, den) = (percent * left * left, 100 * life * life);
    let [red, green, blue] = fresh;
    Color::from_rgb(
        ((red * num + den / 2) / den) as u16,
        ((green * num + den / 2) / den) as u16,
        ((blue * num + den / 2) / den) as u16,
    )
}

/// Sets what stays.
pub fn start() {
    let inks = [
        (Ink::White, Color::from_rgb(30, 30, 30)),
        (Ink::Fixed, Color::from_rgb(6, 26, 31)),
        (Ink::Float, Color::from_rgb(31, 17, 3)),
        (Ink::Grey, Color::from_rgb(19, 19, 21)),
        (Ink::Dark, Color::from_rgb(7, 7, 10)),
    ];
    for (ink, color) in inks {
        if let Some(place) = BG_PALETTE.get(ink as usize) {
            place.write(color);
        }
    }
}

/// Gives every number its color for a picture of that slot.
#[inline(never)]
#[instruction_set(arm::a32)]
#[unsafe(link_section = ".iwram.fade")]
pub fn fade(slot: usize) {
    for (group, colors) in FADING.iter().enumerate() {
        let mut at = slot;
        for &color in colors {
            if let Some(place) = BG_PALETTE.get(1 + group * AGES + at) {
                place.write(color);
            }
            at = if at == 0 { AGES - 1 } else { at - 1 };
        }
    }
}
