//! One picture of lines and dots on two axes, written as a PNG to `examples/pictures`. The examples
//! draw with it; nothing here is needed to simulate.
#![allow(dead_code)] // No example uses all of it.

mod canvas;

use std::ops::Range;
use std::path::Path;

use fixstep::Vec2;
use plotters::coord::CoordTranslate;
use plotters::element::DashedPathElement;
use plotters::prelude::*;

use canvas::{Area, Drawn, SIZE, font, line, px, write};

/// Told apart by most eyes (Okabe and Ito's palette).
pub const BLUE: RGBColor = RGBColor(0, 114, 178);
pub const GREEN: RGBColor = RGBColor(0, 158, 115);
pub const VERMILION: RGBColor = RGBColor(213, 94, 0);
pub const GREY: RGBColor = RGBColor(140, 140, 140);

const HEAD: i32 = 88;
const MARGIN: i32 = 14;
/// Room for the names and labels of the x and the y axis.
const LABELS: (i32, i32) = (50, 66);
const TEXT: i32 = 18;
/// Points of a line that are drawn at once: what is drawn at once is blank where it meets itself.
const PIECE: usize = 50;

pub struct Picture {
    title: String,
    /// Names with units.
    axes: [&'static str; 2],
    /// Whether both axes have one scale.
    equal_axes: bool,
    series: Vec<Series>,
}

/// Points drawn alike. Without a label the head does not name them.
struct Series {
    look: Look,
    color: RGBColor,
    label: String,
    points: Vec<(f64, f64)>,
}

enum Look {
    Line,
    Dashes,
    Dots,
}

impl Picture {
    pub fn new(title: &str, axes: [&'static str; 2]) -> Picture {
        Picture {
            title: title.into(),
            axes,
            equal_axes: false,
            series: Vec::new(),
        }
    }

    /// Gives both axes one scale: a circle is drawn round.
    pub fn with_equal_axes(mut self) -> Picture {
        self.equal_axes = true;
        self
    }

    pub fn line(&mut self, color: RGBColor, label: &str, points: &[Vec2<f64>]) {
        self.add(Look::Line, color, label, points);
    }

    pub fn dashes(&mut self, color: RGBColor, label: &str, points: &[Vec2<f64>]) {
        self.add(Look::Dashes, color, label, points);
    }

    pub fn dots(&mut self, color: RGBColor, label: &str, points: &[Vec2<f64>]) {
        self.add(Look::Dots, color, label, points);
    }

    fn add(&mut self, look: Look, color: RGBColor, label: &str, points: &[Vec2<f64>]) {
        self.series.push(Series {
            look,
            color,
            label: label.into(),
            points: points.iter().map(|point| (point.x, point.y)).collect(),
        });
    }

    /// Writes `examples/pictures/<name>.png`.
    pub fn save(&self, name: &str) -> Drawn {
        let file = format!("examples/pictures/{name}.png");
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(&file);
        canvas::save(&path, |area| self.draw(area))
            .map_err(|error| format!("cannot draw {file}: {error}"))?;
        println!("\ndrawn: {file}");
        Ok(())
    }

    fn draw(&self, area: &Area) -> Drawn {
        let (head, below) = area.split_vertically(px(HEAD));
        write(&head, &self.title, TEXT + 4, (MARGIN, 24))?;
        let [x, y] = self.ranges();
        let mut chart = ChartBuilder::on(&below)
            .margin(px(MARGIN))
            .margin_top(0)
            .x_label_area_size(px(LABELS.0))
            .y_label_area_size(px(LABELS.1))
            .build_cartesian_2d(x, y)?;
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(line(BLACK.mix(0.1), 1))
            .axis_style(line(BLACK, 1))
            .x_desc(self.axes[0])
            .y_desc(self.axes[1])
            .x_label_formatter(&decimal)
            .y_label_formatter(&decimal)
            .label_style(font(TEXT - 2))
            .axis_desc_style(font(TEXT))
            .draw()?;
        let mut x = MARGIN;
        for series in &self.series {
            series.draw(chart.plotting_area(), &series.points)?;
            if !series.label.is_empty() {
                let key = [3, 13, 23, 33].map(|dx| (px(x + dx), px(62)));
                series.draw(&head, &key)?;
                x = write(&head, &series.label, TEXT, (x + 44, 62))? + 30;
            }
        }
        Ok(())
    }

    /// From the least to the greatest of all points, and a little more.
    fn ranges(&self) -> [Range<f64>; 2] {
        let points = || self.series.iter().flat_map(|series| &series.points);
        let ends = [extent(points().map(|p| p.0)), extent(points().map(|p| p.1))];
        let wide = f64::from(SIZE.0 - LABELS.1 - 2 * MARGIN);
        let high = f64::from(SIZE.1 - LABELS.0 - MARGIN - HEAD);
        let [x, y] = ends.map(|[from, to]| to - from);
        let stretched = [x.max(y * wide / high), y.max(x * high / wide)];
        let lengths = if self.equal_axes { stretched } else { [x, y] };
        [0, 1].map(|i| {
            let middle = (ends[i][0] + ends[i][1]) / 2.0;
            let half = 0.53 * lengths[i];
            middle - half..middle + half
        })
    }
}

impl Series {
    fn draw<C: CoordTranslate>(
        &self,
        area: &DrawingArea<BitMapBackend, C>,
        points: &[C::From],
    ) -> Drawn
    where
        C::From: Clone + 'static,
    {
        let points = points.iter().cloned();
        match self.look {
            Look::Line => {
                for start in (0..points.len()).step_by(PIECE) {
                    let piece: Vec<_> = points.clone().skip(start).take(PIECE + 1).collect();
                    area.draw(&PathElement::new(piece, line(self.color, 2)))?;
                }
            }
            Look::Dashes => {
                let style = line(self.color, 2);
                area.draw(&DashedPathElement::new(points, px(7), px(6), style))?;
            }
            Look::Dots => {
                for at in points {
                    area.draw(&Circle::new(at, px(4), self.color.filled()))?;
                }
            }
        }
        Ok(())
    }
}

fn extent(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::MAX, f64::MIN], |[low, high], value| {
        [low.min(value), high.max(value)]
    })
}

/// No digits behind the point that say nothing, and a proper minus.
fn decimal(value: &f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    text.replace('-', "\u{2212}")
}
