//! Pixels and letters of a picture. It is drawn [`FINE`] times as large in both directions and
//! averaged, since the backend rounds to whole pixels. The font comes with the program, so every
//! machine draws the same letters.

use std::error::Error;
use std::path::Path;

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{FontStyle, register_font};

/// Of the finished picture, in pixels, as are all lengths that go through [`px`].
pub const SIZE: (i32, i32) = (960, 640);
const FINE: i32 = 3;
/// Bytes of a pixel.
const RGB: usize = 3;
const FONT: &str = "sans-serif";

pub type Area<'a> = DrawingArea<BitMapBackend<'a>, Shift>;
pub type Drawn<T = ()> = Result<T, Box<dyn Error>>;

/// Draws with `draw` and writes a PNG.
pub fn save(path: &Path, draw: impl FnOnce(&Area) -> Drawn) -> Drawn {
    save_sized(path, SIZE, draw)
}

/// As [`save`], of another size.
pub fn save_sized(path: &Path, size: (i32, i32), draw: impl FnOnce(&Area) -> Drawn) -> Drawn {
    register_font(FONT, FontStyle::Normal, epaint_default_fonts::UBUNTU_LIGHT)
        .map_err(|_| "the font cannot be read")?;
    let (pixels, fine) = (pair(size.0, size.1), pair(px(size.0), px(size.1)));
    let mut large = vec![0; (fine.0 * fine.1) as usize * RGB];
    let area = BitMapBackend::with_buffer(&mut large, fine).into_drawing_area();
    area.fill(&WHITE)?;
    draw(&area)?;
    area.present()?;
    drop(area);
    let mut small = BitMapBackend::new(path, pixels);
    small.blit_bitmap((0, 0), pixels, &averaged(&large, size))?;
    Ok(small.present()?)
}

fn pair(width: i32, height: i32) -> (u32, u32) {
    (width as u32, height as u32)
}

/// Each pixel the mean of a square of `FINE * FINE`.
fn averaged(large: &[u8], size: (i32, i32)) -> Vec<u8> {
    let [width, height, fine] = [size.0, size.1, FINE].map(|length| length as usize);
    let mean = |i: usize| {
        let (channel, x, y) = (i % RGB, i / RGB % width, i / RGB / width);
        let row = |dy| ((y * fine + dy) * width + x) * fine;
        let square = (0..fine).flat_map(|dy| (0..fine).map(move |dx| row(dy) + dx));
        let bytes = square.map(|pixel| usize::from(large[pixel * RGB + channel]));
        (bytes.sum::<usize>() / (fine * fine)) as u8
    };
    (0..width * height * RGB).map(mean).collect()
}

/// Pixels of the finished picture in those that are drawn.
pub const fn px(pixels: i32) -> i32 {
    pixels * FINE
}

/// A line `width` pixels wide.
pub fn line(color: impl Into<RGBAColor>, width: i32) -> ShapeStyle {
    color.into().stroke_width(px(width) as u32)
}

/// Black text, placed by the middle of its left edge.
pub fn font(size: i32) -> TextStyle<'static> {
    (FONT, px(size))
        .into_text_style(&(0, 0))
        .color(&BLACK)
        .pos(Pos::new(HPos::Left, VPos::Center))
}

/// Writes `text` at (`x`, `y`) and returns where it ends. Word by word: the space of the font is so narrow that
/// "A throw" reads as "Athrow".
pub fn write(area: &Area, text: &str, size: i32, (x, y): (i32, i32)) -> Drawn<i32> {
    let (style, mut at) = (font(size), px(x));
    let (space, _) = area.estimate_text_size(" ", &style)?;
    for word in text.split(' ') {
        // The middle of the font's box is above that of its letters.
        area.draw_text(word, &style, (at, px(y + 2)))?;
        let (width, _) = area.estimate_text_size(word, &style)?;
        at += (width + 8 * space / 5) as i32;
    }
    Ok((at - (8 * space / 5) as i32) / FINE)
}
