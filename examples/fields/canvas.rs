//! A picture in the making: drawn [`FINE`] times as large as it will be, in both directions, and
//! averaged, since the backend rounds to whole pixels and slopes need smooth lines.

use std::error::Error;
use std::path::Path;

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{FontStyle, register_font};

/// Of the finished picture.
const SIZE: (u32, u32) = (960, 640);
const FINE: u32 = 3;
/// Bytes of a pixel.
const RGB: usize = 3;
const FONT: &str = "sans-serif";

pub type Area<'a> = DrawingArea<BitMapBackend<'a>, Shift>;
pub type Drawn = Result<(), Box<dyn Error>>;

/// Draws with `draw` and writes a PNG.
pub fn save(path: &Path, draw: impl FnOnce(&Area) -> Drawn) -> Drawn {
    register_font(FONT, FontStyle::Normal, epaint_default_fonts::UBUNTU_LIGHT)
        .map_err(|_| "the font cannot be read")?;
    let (width, height) = (SIZE.0 * FINE, SIZE.1 * FINE);
    let mut large = vec![0; (width * height) as usize * RGB];
    let area = BitMapBackend::with_buffer(&mut large, (width, height)).into_drawing_area();
    area.fill(&WHITE)?;
    draw(&area)?;
    area.present()?;
    drop(area);
    let mut small = BitMapBackend::new(path, SIZE);
    small.blit_bitmap((0, 0), SIZE, &averaged(&large))?;
    Ok(small.present()?)
}

/// Each pixel the mean of a square of `FINE * FINE`.
fn averaged(large: &[u8]) -> Vec<u8> {
    let (width, height, fine) = (SIZE.0 as usize, SIZE.1 as usize, FINE as usize);
    let mean = |i: usize| {
        let (channel, x, y) = (i % RGB, i / RGB % width, i / RGB / width);
        let byte = |dx, dy| {
            let pixel = (y * fine + dy) * width * fine + x * fine + dx;
            usize::from(large[pixel * RGB + channel])
        };
        let rows = 0..fine;
        let square = rows.flat_map(|dy| (0..fine).map(move |dx| byte(dx, dy)));
        (square.sum::<usize>() / (fine * fine)) as u8
    };
    (0..width * height * RGB).map(mean).collect()
}

/// Pixels of the finished picture in those that are drawn.
pub const fn px(pixels: i32) -> i32 {
    pixels * FINE as i32
}

/// A line `width` pixels wide.
pub fn line(color: impl Into<RGBAColor>, width: i32) -> ShapeStyle {
    color.into().stroke_width(px(width) as u32)
}

/// Black text `size` pixels high, placed by the middle of its left edge.
pub fn font(size: i32) -> TextStyle<'static> {
    (FONT, px(size))
        .into_text_style(&SIZE)
        .color(&BLACK)
        .pos(Pos::new(HPos::Left, VPos::Center))
}

/// Writes `text` at (`x`, `y`) and returns where it ends, all in pixels of the finished picture.
pub fn write(
    area: &Area,
    text: &str,
    size: i32,
    (x, y): (i32, i32),
) -> Result<i32, Box<dyn Error>> {
    // The middle of the font's box is above that of its letters.
    area.draw_text(text, &font(size), (px(x), px(y + 2)))?;
    let (width, _) = area.estimate_text_size(text, &font(size))?;
    Ok(x + width.div_ceil(FINE) as i32)
}
