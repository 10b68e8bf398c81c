//! Two axes, each even or by powers of ten, and what is drawn between them.

use std::error::Error;
use std::ops::Range;

use plotters::chart::ChartContext;
use plotters::coord::Shift;
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use plotters::element::DashedPathElement;
use plotters::prelude::*;

use crate::canvas::{Area, Drawn, font, line, px, write};

pub const BLUE: RGBColor = RGBColor(0, 114, 178);
pub const SKY: RGBColor = RGBColor(86, 180, 233);
pub const GREEN: RGBColor = RGBColor(0, 158, 115);
pub const ORANGE: RGBColor = RGBColor(230, 159, 0);
pub const VERMILION: RGBColor = RGBColor(213, 94, 0);
pub const PURPLE: RGBColor = RGBColor(204, 121, 167);
pub const GREY: RGBColor = RGBColor(140, 140, 140);

/// Height of labels, in pixels.
pub const TEXT: i32 = 15;
/// Points of a line that are drawn at once: what is drawn at once is blank where it meets itself.
const PIECE: usize = 50;

/// A range of numbers, drawn evenly or by their logarithms.
#[derive(Clone, Debug)]
pub struct Axis {
    pub name: &'static str,
    /// Both ends.
    pub ends: [f64; 2],
    log: bool,
    ticks: Vec<f64>,
}

impl Axis {
    pub fn linear(name: &'static str, ends: [f64; 2], ticks: &[f64]) -> Axis {
        Axis {
            name,
            ends,
            log: false,
            ticks: ticks.to_vec(),
        }
    }

    /// By powers of ten, with a tick at each `every` of them.
    pub fn decades(name: &'static str, ends: [i32; 2], every: usize) -> Axis {
        let ticks = (ends[0]..=ends[1]).step_by(every).map(|n| 10_f64.powi(n));
        Axis::log(
            name,
            ends.map(|n| 10_f64.powi(n)),
            &ticks.collect::<Vec<_>>(),
        )
    }

    pub fn log(name: &'static str, ends: [f64; 2], ticks: &[f64]) -> Axis {
        Axis {
            name,
            ends,
            log: true,
            ticks: ticks.to_vec(),
        }
    }

    fn place(&self, value: f64) -> f64 {
        if self.log { value.log10() } else { value }
    }

    /// The value at a share of the way along the axis.
    pub fn value(&self, share: f64) -> f64 {
        let [low, high] = self.ends.map(|end| self.place(end));
        let place = low + share * (high - low);
        if self.log { 10_f64.powf(place) } else { place }
    }
}

impl Ranged for Axis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (from, to): (i32, i32)) -> i32 {
        let [low, high] = self.ends.map(|end| self.place(end));
        let share = (self.place(value.clamp(self.ends[0], self.ends[1])) - low) / (high - low);
        from + (share * f64::from(to - from)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.ticks.clone()
    }

    fn range(&self) -> Range<f64> {
        self.ends[0]..self.ends[1]
    }
}

/// Plain, but for powers of ten that are far from one; with a proper minus.
impl ValueFormatter<f64> for Axis {
    fn format(value: &f64) -> String {
        let text = match value.abs() {
            small if small > 0.0 && small < 0.009 => format!("{value:.0e}"),
            large if large >= 9999.0 => format!("{value:.0e}"),
            _ => {
                let text = format!("{value:.3}");
                text.trim_end_matches('0').trim_end_matches('.').into()
            }
        };
        text.replace('-', "\u{2212}")
    }
}

type Coord = Cartesian2d<Axis, Axis>;

/// A panel, ready to be drawn into.
pub struct Panel<'a> {
    chart: ChartContext<'a, BitMapBackend<'a>, Coord>,
}

impl<'a> Panel<'a> {
    pub fn new(area: &Area<'a>, x: Axis, y: Axis) -> Drawn<Panel<'a>> {
        let room = |axis: &Axis, named, plain| px(if axis.name.is_empty() { plain } else { named });
        let names = [x.name, y.name];
        let mut chart = ChartBuilder::on(area)
            .margin(px(4))
            .margin_right(px(14))
            .x_label_area_size(room(&x, 42, 22))
            .y_label_area_size(room(&y, 58, 46))
            .build_cartesian_2d(x, y)?;
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(line(BLACK.mix(0.12), 1))
            .axis_style(line(BLACK, 1))
            .set_all_tick_mark_size(px(4))
            .x_desc(names[0])
            .y_desc(names[1])
            .label_style(font(TEXT - 2))
            .axis_desc_style(font(TEXT - 1))
            .draw()?;
        Ok(Panel { chart })
    }

    pub fn line(&self, points: &[[f64; 2]], color: impl Into<RGBAColor>, width: i32) -> Drawn {
        let (places, style) = (places(points), line(color, width));
        for start in (0..places.len()).step_by(PIECE) {
            let piece: Vec<_> = places.iter().skip(start).take(PIECE + 1).copied().collect();
            let area = self.chart.plotting_area();
            area.draw(&PathElement::new(piece, style))?;
        }
        Ok(())
    }

    pub fn dashes(&self, points: &[[f64; 2]], color: impl Into<RGBAColor>, width: i32) -> Drawn {
        let places = places(points).into_iter();
        let dashes = DashedPathElement::new(places, px(6), px(5), line(color, width));
        Ok(self.chart.plotting_area().draw(&dashes)?)
    }

    pub fn dots(&self, points: &[[f64; 2]], color: RGBColor, radius: i32) -> Drawn {
        for place in places(points) {
            let dot = Circle::new(place, radius, color.filled());
            self.chart.plotting_area().draw(&dot)?;
        }
        Ok(())
    }

    /// Everything between two lines of points.
    pub fn band(&self, low: &[[f64; 2]], high: &[[f64; 2]], color: RGBAColor) -> Drawn {
        let around = low.iter().chain(high.iter().rev()).copied();
        let places = places(&around.collect::<Vec<_>>());
        let area = self.chart.plotting_area();
        Ok(area.draw(&Polygon::new(places, color.filled()))?)
    }

    pub fn cell(&self, corners: [[f64; 2]; 2], color: impl Into<RGBAColor>) -> Drawn {
        let cell = Rectangle::new(corners.map(|[x, y]| (x, y)), color.into().filled());
        Ok(self.chart.plotting_area().draw(&cell)?)
    }

    /// Text whose left end is at a point.
    pub fn text(&self, at: [f64; 2], text: &str, color: RGBColor) -> Drawn {
        let style = font(TEXT - 2).color(&color);
        let text = Text::new(text.to_string(), (at[0], at[1]), style);
        Ok(self.chart.plotting_area().draw(&text)?)
    }
}

/// A piece of line and what it stands for, at (`x`, `y`); returns where the next one may begin.
pub fn key(area: &Area, (x, y): (i32, i32), color: RGBColor, text: &str) -> Drawn<i32> {
    let ends = [(px(x), px(y)), (px(x + 20), px(y))];
    area.draw(&PathElement::new(ends, line(color, 3)))?;
    Ok(write(area, text, TEXT - 1, (x + 26, y))? + 16)
}

/// A square and what it stands for.
pub fn patch(area: &Area, (x, y): (i32, i32), color: RGBColor, text: &str) -> Drawn<i32> {
    let corners = [(px(x), px(y - 7)), (px(x + 20), px(y + 7))];
    area.draw(&Rectangle::new(corners, color.filled()))?;
    area.draw(&Rectangle::new(corners, line(GREY, 1)))?;
    Ok(write(area, text, TEXT - 1, (x + 26, y))? + 16)
}

/// Areas of a grid, row by row.
pub fn grid<'a>(
    area: &Area<'a>,
    rows: usize,
    columns: usize,
) -> Vec<DrawingArea<BitMapBackend<'a>, Shift>> {
    area.split_evenly((rows, columns))
}

/// Numbers of a row, from the column on.
pub fn numbers(row: &[String], from: usize) -> Result<Vec<f64>, Box<dyn Error>> {
    row[from..]
        .iter()
        .map(|text| {
            text.parse()
                .map_err(|_| format!("not a number: {text}").into())
        })
        .collect()
}

fn places(points: &[[f64; 2]]) -> Vec<(f64, f64)> {
    points.iter().map(|&[x, y]| (x, y)).collect()
}
