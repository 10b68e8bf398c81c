//! The showcase: one scene twice, in fixed point and in `f32`, from the same start. While they agree
//! their trails are white; then they part.
//!
//! A chain on a hook, a dumbbell and three balls, under gravity, springs and drag, in a room of 15 m.
//! `A` changes the number type, `L` and `R` the rate, `START` starts anew.
//!
//! | file | holds |
//! |---|---|
//! | `scene.rs` | the bodies, their forces, the edges, and the step as ARM code in fast RAM |
//! | `race.rs` | the two worlds, the choice of type and rate, and what a frame costs |
//! | `canvas.rs` | trails that fade |
//! | `colors.rs` | the palette, which does the fading |
//! | `text.rs` | words and numbers on the screen |
#![no_std]
#![no_main]

mod canvas;
mod colors;
mod race;
mod scene;
mod text;

use fixstep::Error;
use gba::prelude::*;

use canvas::{Canvas, Who};
use colors::Ink;
use race::{Cost, Race};
use scene::place;
use text::Text;

/// Pictures since the start, counted by the screen's interrupt.
static PICTURES: GbaCell<u32> = GbaCell::new(0);

#[unsafe(link_section = ".iwram.on_interrupt")]
extern "C" fn on_interrupt(_: IrqBits) {
    PICTURES.write(PICTURES.read().wrapping_add(1));
}

fn show_screen() {
    RUST_IRQ_HANDLER.write(Some(on_interrupt));
    DISPSTAT.write(DisplayStatus::new().with_irq_vblank(true));
    IE.write(IrqBits::VBLANK);
    IME.write(true);
    let bitmap = DisplayControl::new().with_video_mode(VideoMode::_4);
    DISPCNT.write(bitmap.with_show_bg2(true));
}

fn draw(canvas: &mut Canvas, race: &Race) {
    for (who, positions) in [(Who::Float, &race.float_at), (Who::Fixed, &race.fixed_at)] {
        for [from, to] in scene::LINKS {
            if let (Some(&from), Some(&to)) = (positions.get(from), positions.get(to)) {
                canvas.line(who, place(from), place(to));
            }
        }
        for &at in positions {
            canvas.dot(who, place(at));
        }
    }
}

/// Writes one row of words.
fn report(row: usize, text: &mut Text, race: &Race) {
    text.at(row, Ink::White);
    match row {
        0 => {
            text.word("fixstep  ").ink(Ink::Fixed).word(race.scalar());
            text.word("  ").ink(Ink::Grey).word(race.rate());
        }
        1 => costs(text.ink(Ink::Fixed), race.scalar(), race.cost_of_fixed),
        2 => costs(text.ink(Ink::Float), "f32", race.cost_of_float),
        _ => {
            text.word("apart ")
                .fraction(race.apart())
                .word(" m")
                .tab(20);
            let rate = race.pictures_per_second();
            text.ink(Ink::Grey).hundredths(rate).word(" fps");
        }
    }
    text.end();
}

fn costs(text: &mut Text, scalar: &str, cost: Cost) {
    text.word(scalar)
        .tab(7)
        .number(cost.cycles(), 6)
        .word(" cycles ");
    text.tenths(cost.tenths_of_percent(), 4).word(" %");
}

/// A button that is down now and was not before.
fn pressed(before: &mut KeyInput) -> KeyInput {
    let now = KEYINPUT.read();
    // Bits of buttons that are down are clear.
    let fresh = KeyInput::from(now.to_u16() | !before.to_u16());
    *before = now;
    fresh
}

fn play() -> Result<(), Error> {
    let mut race = Race::new()?;
    let canvas = unsafe { Canvas::take() }; // SAFETY: here alone
    let mut text = Text::new();
    let mut held = KeyInput::new();
    colors::start();
    canvas.clear();
    text::frame();
    show_screen();
    let mut last = PICTURES.read();
    loop {
        VBlankIntrWait();
        let now = PICTURES.read();
        let since = now.wrapping_sub(last);
        last = now;
        canvas.next();
        draw(canvas, &race);
        if let Some(row) = canvas.row_that_is_due() {
            report(row, &mut text, &race);
        }
        let keys = pressed(&mut held);
        if race.choose(keys.a(), keys.r() as i32 - keys.l() as i32, keys.start())? {
            canvas.clear();
        }
        race.advance(since);
    }
}

board::image!(|_| play());
