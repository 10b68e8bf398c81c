//! Two log axes on a picture: where a value lies in pixels, ticks and their names.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::canvas::{Area, Drawn, font, line, px};

/// Height of the names of ticks and axes, in pixels.
const TEXT: i32 = 15;

/// Values of both axes, and the pixels of their ends.
pub struct Frame {
    pub x: [f64; 2],
    pub y: [f64; 2],
    pub left: i32,
    pub right: i32,
    pub top: i32,
    pub bottom: i32,
}

impl Frame {
    /// In the fine pixels that are drawn; what lies outside is drawn on the edge.
    pub fn at(&self, (x, y): (f64, f64)) -> (i32, i32) {
        let along = |[low, high]: [f64; 2], value: f64| {
            ((value / low).ln() / (high / low).ln()).clamp(0.0, 1.0)
        };
        let between = |from: i32, to: i32, part: f64| {
            px(from) + (f64::from(px(to - from)) * part).round() as i32
        };
        (
            between(self.left, self.right, along(self.x, x)),
            between(self.bottom, self.top, along(self.y, y)),
        )
    }

    /// Lines at powers of ten, and a box around all.
    pub fn draw(&self, area: &Area, [x_name, y_name]: [&str; 2]) -> Drawn {
        let middle = |style: TextStyle<'static>, h, v| style.pos(Pos::new(h, v));
        let below = || middle(font(TEXT), HPos::Center, VPos::Top);
        let beside = || middle(font(TEXT), HPos::Right, VPos::Center);
        let mesh = line(BLACK.mix(0.09), 1);
        for decade in decades(self.x) {
            let (x, _) = self.at((value(decade), self.y[0]));
            area.draw(&PathElement::new(
                [(x, px(self.top)), (x, px(self.bottom))],
                mesh,
            ))?;
            area.draw_text(&power(decade), &below(), (x, px(self.bottom + 7)))?;
        }
        for decade in decades(self.y) {
            let (_, y) = self.at((self.x[0], value(decade)));
            area.draw(&PathElement::new(
                [(px(self.left), y), (px(self.right), y)],
                mesh,
            ))?;
            area.draw_text(&power(decade), &beside(), (px(self.left - 6), y + px(2)))?;
        }
        let ends = [
            (px(self.left), px(self.top)),
            (px(self.right), px(self.bottom)),
        ];
        area.draw(&Rectangle::new(ends, line(BLACK, 1)))?;
        let centre = (px((self.left + self.right) / 2), px(self.bottom + 27));
        area.draw_text(x_name, &below(), centre)?;
        let turned = below().transform(FontTransform::Rotate270);
        let side = (px(self.left - 66), px((self.top + self.bottom) / 2));
        Ok(area.draw_text(y_name, &turned, side)?)
    }
}

fn decades([low, high]: [f64; 2]) -> std::ops::RangeInclusive<i32> {
    (low.log10() - 1e-9).ceil() as i32..=(high.log10() + 1e-9).floor() as i32
}

fn value(decade: i32) -> f64 {
    10_f64.powi(decade)
}

/// `1e-7` with a proper minus; whole numbers up to a thousand as they are.
fn power(decade: i32) -> String {
    match decade {
        0..=3 => 10_i32.pow(decade as u32).to_string(),
        _ => format!("1e{decade}").replace('-', "\u{2212}"),
    }
}
