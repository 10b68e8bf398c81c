//! What the panels of both pictures share: axes, the slope field, curves, marks and their legend.

use std::error::Error;
use std::ops::Range;

use plotters::coord::CoordTranslate;
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;

use crate::canvas::{Area, Drawn, font, line, px, write};
use crate::flight::Run;

/// Height of most text, in pixels.
pub const TEXT: i32 = 17;

/// Told apart by most eyes (Okabe and Ito's palette).
pub const VERMILION: RGBColor = RGBColor(213, 94, 0);
pub const BLUE: RGBColor = RGBColor(0, 114, 178);
pub const GREEN: RGBColor = RGBColor(0, 158, 115);

type Plane = Cartesian2d<RangedCoordf64, RangedCoordf64>;
pub type Chart<'a, 'b> = ChartContext<'a, BitMapBackend<'b>, Plane>;

/// The two axes of a panel.
pub struct Axes {
    pub x: Range<f64>,
    pub y: Range<f64>,
    /// Names with units.
    pub names: [&'static str; 2],
    /// About how many labels.
    pub labels: [usize; 2],
    /// Room on the right, in pixels.
    pub right: i32,
}

impl Axes {
    pub fn draw<'a, 'b>(self, area: &'a Area<'b>) -> Result<Chart<'a, 'b>, Box<dyn Error>> {
        let mut chart = ChartBuilder::on(area)
            .margin(px(8))
            .margin_right(px(self.right))
            .x_label_area_size(px(48))
            .y_label_area_size(px(56))
            .build_cartesian_2d(self.x, self.y)?;
        chart
            .configure_mesh()
            .disable_mesh()
            .axis_style(line(BLACK, 1))
            .set_all_tick_mark_size(px(5))
            .x_desc(self.names[0])
            .y_desc(self.names[1])
            .x_labels(self.labels[0])
            .y_labels(self.labels[1])
            .x_label_formatter(&decimal)
            .y_label_formatter(&decimal)
            .label_style(font(TEXT - 2))
            .axis_desc_style(font(TEXT))
            .draw()?;
        Ok(chart)
    }
}

/// One digit behind the point where there is one, and a proper minus.
fn decimal(value: &f64) -> String {
    let text = format!("{value:.1}");
    text.trim_end_matches(".0").replace('-', "\u{2212}")
}

/// Dashes of one length on a grid, along the slope dy/dx at their middle.
pub fn slope_field(chart: &mut Chart, slope: impl Fn(f64, f64) -> f64) -> Drawn {
    let cell = f64::from(px(26));
    let (width, height) = chart.plotting_area().dim_in_pixel();
    let (x, y) = (chart.x_range(), chart.y_range());
    let columns = (f64::from(width) / cell).round();
    let rows = (f64::from(height) / cell).round();
    let (wide, high) = ((x.end - x.start) / columns, (y.end - y.start) / rows);
    let dash = |column: u32, row: u32| {
        let middle_x = x.start + wide * (f64::from(column) + 0.5);
        let middle_y = y.start + high * (f64::from(row) + 0.5);
        // Cells are squares on paper: measured in them, every dash is equally long.
        let steep = slope(middle_x, middle_y) * wide / high;
        let across = 0.32 / steep.hypot(1.0);
        let (dx, dy) = (across * wide, across * steep * high);
        [
            (middle_x - dx, middle_y - dy),
            (middle_x + dx, middle_y + dy),
        ]
    };
    let places = (0..columns as u32).flat_map(|c| (0..rows as u32).map(move |r| (c, r)));
    let dashes =
        places.map(|(column, row)| PathElement::new(dash(column, row), line(BLACK.mix(0.35), 1)));
    chart.draw_series(dashes)?;
    Ok(())
}

/// An exact solution; `main` for the one that the methods should follow.
pub fn curve(chart: &mut Chart, main: bool, value: impl Fn(f64) -> f64) -> Drawn {
    const PIECES: u32 = 400;
    let x = chart.x_range();
    let at = |i: u32| x.start + (x.end - x.start) * f64::from(i) / f64::from(PIECES);
    let points = (0..=PIECES).map(|i| (at(i), value(at(i))));
    let style = if main {
        line(BLACK, 2)
    } else {
        line(BLACK.mix(0.55), 1)
    };
    chart.draw_series(LineSeries::new(points, style))?;
    Ok(())
}

/// The colour and mark of a run.
#[derive(Clone, Copy)]
pub struct Style {
    pub color: RGBColor,
    pub mark: Mark,
}

#[derive(Clone, Copy)]
pub enum Mark {
    Disc,
    Triangle,
    Square,
}

/// A run as far as the panel reaches: its marks, joined by a thin line.
pub fn trace(chart: &mut Chart, run: &Run, style: Style) -> Drawn {
    let range = chart.x_range();
    let shown = run.samples.iter().filter(|s| s.at <= range.end);
    let points: Vec<(f64, f64)> = shown.map(|s| (s.at, s.value)).collect();
    chart.draw_series(LineSeries::new(points.clone(), line(style.color, 1)))?;
    for at in points {
        mark(chart.plotting_area(), at, style)?;
    }
    Ok(())
}

fn mark<C: CoordTranslate>(
    area: &DrawingArea<BitMapBackend, C>,
    at: C::From,
    style: Style,
) -> Drawn {
    let (at, fill) = (EmptyElement::at(at), style.color.filled());
    let half = px(5);
    match style.mark {
        Mark::Disc => area.draw(&(at + Circle::new((0, 0), half, fill)))?,
        Mark::Triangle => area.draw(&(at + TriangleMarker::new((0, 0), px(7), fill)))?,
        Mark::Square => area.draw(&(at + Rectangle::new([(-half, -half), (half, half)], fill)))?,
    }
    Ok(())
}

/// A mark on its line and what it stands for, at (`x`, `y`); returns where the next one may begin.
pub fn legend(
    area: &Area,
    (x, y): (i32, i32),
    style: Style,
    text: &str,
) -> Result<i32, Box<dyn Error>> {
    let ends = [(px(x), px(y)), (px(x + 30), px(y))];
    area.draw(&PathElement::new(ends, line(style.color, 1)))?;
    mark(area, (px(x + 15), px(y)), style)?;
    Ok(write(area, text, TEXT, (x + 38, y))? + 32)
}
