//! Names written beside lines, none over another.

use plotters::prelude::*;

use crate::canvas::{Area, Drawn, font, px};

/// Boxes that are taken, in fine pixels: left, top, right, bottom.
pub struct Labels {
    room: [i32; 4],
    taken: Vec<[i32; 4]>,
}

impl Labels {
    /// All within `room`.
    pub fn new(room: [i32; 4]) -> Labels {
        let taken = Vec::new();
        Labels { room, taken }
    }

    /// Keeps names away from a line.
    pub fn keep_off(&mut self, points: &[(i32, i32)]) {
        let r = px(5);
        for ends in points.windows(2) {
            let ((x0, y0), (x1, y1)) = (ends[0], ends[1]);
            let parts = ((x1 - x0).abs() + (y1 - y0).abs()) / r + 1;
            let at = |i: i32| (x0 + (x1 - x0) * i / parts, y0 + (y1 - y0) * i / parts);
            let around = |(x, y): (i32, i32)| [x - r, y - r, x + r, y + r];
            self.taken.extend((0..=parts).map(at).map(around));
        }
    }

    /// Writes `text` above or below the first of `places` where there is room; false if there is none.
    pub fn write(
        &mut self,
        area: &Area,
        text: &str,
        (size, color): (i32, RGBColor),
        places: &[(i32, i32)],
    ) -> Drawn<bool> {
        let style = font(size).color(&color);
        let (width, height) = area.estimate_text_size(text, &style)?;
        let (width, height) = (width as i32, height as i32);
        let [left, top, right, bottom] = self.room;
        // Close by if it can be, up to three lines off.
        let far = [-12, 12, -24, 24, -36, 36];
        let around = far.iter().flat_map(|dy| {
            let left = move |&(x, y): &(i32, i32)| (x - width / 2, y + px(*dy));
            places.iter().map(left)
        });
        for (x, y) in around {
            let gap = px(4);
            let taken = [x - gap, y - height / 2, x + width + gap, y + height / 2];
            let inside = x > left && taken[2] < right && taken[1] > top && taken[3] < bottom;
            if inside && !self.taken.iter().any(|other| meets(other, &taken)) {
                self.taken.push(taken);
                let back = [(x, taken[1] + px(2)), (x + width, taken[3] - px(2))];
                area.draw(&Rectangle::new(back, WHITE.mix(0.8).filled()))?;
                area.draw_text(text, &style, (x, y + px(2)))?;
                return Ok(true);
            }
        }
        Ok(false)
    }
}

fn meets(a: &[i32; 4], b: &[i32; 4]) -> bool {
    a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]
}
