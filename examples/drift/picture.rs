//! One picture a scene, as SVG and PNG: a panel for each method, time and error on log axes.
//!
//! A coloured line is what a scalar adds to the method's own error, `|X - M|` of module `compare`;
//! the dashed black line is that error of the method. Where colours run below black, the scalar is
//! good enough for the method. `f64` is the reference and has no line.
//!
//! What is out of range or above the top edge is a cross on it; what is 0 or below the bottom edge
//! lies on that. Lines on an edge are drawn side by side.

use std::error::Error;
use std::path::Path;

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::{FontStyle, register_font};

use crate::cli::{MethodName, Options, ScalarName, name};
use crate::compare::Row;
use crate::scene::Scene;
use crate::work::Case;

const SIZE: (u32, u32) = (960, 720);
/// Also the generic family of SVG.
const FONT: &str = "sans-serif";
const TEXT: i32 = 15;
const CAPTION: &str = "In colour what a number type adds to the method's own error. \
                       Crosses: out of range or above. On the bottom edge: 0, or too little.";
/// Errors outside are of no interest: smaller than any scene, larger than any world.
const LIMITS: [f64; 2] = [1e-10, 1e4];

/// Draws every scene into `folder`.
pub fn draw_all(folder: &Path, options: &Options, cases: &[Case]) -> Result<(), Box<dyn Error>> {
    register_font(FONT, FontStyle::Normal, epaint_default_fonts::UBUNTU_LIGHT)
        .map_err(|_| "the font cannot be read")?;
    for &scene in &options.scene {
        let cases: Vec<&Case> = cases
            .iter()
            .filter(|case| case.scene.name == scene.name)
            .collect();
        let (methods, scalars) = (&options.method, &options.scalar);
        let sheet = Sheet {
            scene,
            methods,
            scalars,
            cases: &cases,
        };
        let path = |ending| folder.join(format!("{}.{ending}", scene.name));
        sheet.draw(&SVGBackend::new(&path("svg"), SIZE).into_drawing_area())?;
        sheet.draw(&BitMapBackend::new(&path("png"), SIZE).into_drawing_area())?;
    }
    Ok(())
}

/// One picture.
struct Sheet<'a> {
    scene: &'a Scene,
    methods: &'a [MethodName],
    scalars: &'a [ScalarName],
    cases: &'a [&'a Case],
}

type Area<DB> = DrawingArea<DB, Shift>;
type Drawn = Result<(), Box<dyn Error>>;

impl Sheet<'_> {
    fn draw<DB: DrawingBackend>(&self, area: &Area<DB>) -> Drawn
    where
        DB::ErrorType: 'static,
    {
        area.fill(&WHITE)?;
        let (head, panels) = area.split_vertically(92);
        write(&head, self.scene.title, 20, (16, 10))?;
        write(&head, CAPTION, 14, (16, 38))?;
        self.legend(&head)?;
        let Some(axes) = Axes::of(self.cases) else {
            write(&panels, "No scalar can hold this scene.", TEXT, (16, 12))?;
            return Ok(area.present()?);
        };
        let columns = self.methods.len().min(2);
        let panels = panels.split_evenly((self.methods.len().div_ceil(2), columns));
        for (&method, panel) in self.methods.iter().zip(&panels) {
            let cases: Vec<&Case> = self
                .cases
                .iter()
                .copied()
                .filter(|case| case.method == method)
                .collect();
            axes.panel(panel, &name(method), &cases)?;
        }
        Ok(area.present()?)
    }

    fn legend<DB: DrawingBackend>(&self, head: &Area<DB>) -> Drawn
    where
        DB::ErrorType: 'static,
    {
        let scalars = self
            .scalars
            .iter()
            .filter_map(|&scalar| Some((name(scalar), color(scalar)?)));
        let mut x = 16;
        for (text, color) in scalars {
            let line = [(x, 72), (x + 26, 72)];
            head.draw(&PathElement::new(line, color.stroke_width(3)))?;
            head.draw_text(&text, &font(TEXT), (x + 32, 64))?;
            x += 52 + 9 * text.len() as i32;
        }
        for dash in [0, 10, 20] {
            let line = [(x + dash, 72), (x + dash + 6, 72)];
            head.draw(&PathElement::new(line, BLACK.stroke_width(1)))?;
        }
        write(head, "the method itself", TEXT, (x + 32, 64))
    }
}

/// The ranges that all panels of a picture share, in seconds and metres.
struct Axes {
    x: [f64; 2],
    y: [f64; 2],
}

impl Axes {
    /// From the first tick to the last, and over all errors in whole decades.
    fn of(cases: &[&Case]) -> Option<Axes> {
        let rows = || cases.iter().flat_map(|case| case.rows.iter().flatten());
        let errors = rows().flat_map(|row| [row.scalar, row.method]);
        let errors = errors.filter(|&error| error > LIMITS[0] && error < f64::INFINITY);
        let (low, high) = errors.fold((1e-3, 1e-2), |(low, high), error: f64| {
            (error.min(low), error.max(high))
        });
        let decade = |exponent: f64| 10_f64.powf(exponent).clamp(LIMITS[0], LIMITS[1]);
        let (first, last) = (rows().next()?.seconds, rows().last()?.seconds);
        Some(Axes {
            x: [first, last.max(2.0 * first)],
            y: [decade(low.log10().floor()), decade(high.log10().ceil())],
        })
    }

    fn panel<DB: DrawingBackend>(&self, area: &Area<DB>, title: &str, cases: &[&Case]) -> Drawn
    where
        DB::ErrorType: 'static,
    {
        let ([x0, x1], [y0, y1]) = (self.x, self.y);
        let mut chart = ChartBuilder::on(area)
            .caption(title, font(17))
            .margin(6)
            .margin_left(12)
            .margin_right(20)
            .x_label_area_size(42)
            .y_label_area_size(64)
            .build_cartesian_2d((x0..x1).log_scale(), (y0..y1).log_scale())?;
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(BLACK.mix(0.12))
            .x_desc("time, s")
            .y_desc("error, m")
            .x_labels(8)
            .y_labels(7)
            .x_label_formatter(&decimal)
            .y_label_formatter(&|y| format!("{y:.0e}"))
            .label_style(font(TEXT))
            .axis_desc_style(font(TEXT))
            .draw()?;
        for (lane, case) in (1..).zip(cases) {
            let (Some(color), Ok(rows)) = (color(case.scalar), &case.rows) else {
                continue;
            };
            let (line, crosses) = self.points(rows, lane, |row| row.scalar);
            chart.draw_series(LineSeries::new(line, color.stroke_width(2)))?;
            chart.draw_series(crosses.into_iter().map(|at| Cross::new(at, 3, color)))?;
        }
        if let Some(rows) = cases.iter().find_map(|case| case.rows.as_ref().ok()) {
            let (line, crosses) = self.points(rows, 0, |row| row.method);
            chart.draw_series(DashedLineSeries::new(line, 6, 4, BLACK.stroke_width(1)))?;
            chart.draw_series(crosses.into_iter().map(|at| Cross::new(at, 3, BLACK)))?;
        }
        Ok(())
    }

    /// Points of a line, and crosses where it is above the top edge.
    fn points(&self, rows: &[Row], lane: u32, error: fn(&Row) -> f64) -> (Points, Points) {
        let [low, high] = self.y;
        let aside = (high / low).powf(0.015 * f64::from(lane));
        let above = |row: &&Row| error(row) > high;
        let line = rows.iter().filter(|row| !above(row));
        let line = line
            .map(|row| (row.seconds, error(row).max(low * aside)))
            .collect();
        let crosses = rows.iter().filter(above).step_by(3);
        (
            line,
            crosses.map(|row| (row.seconds, high / aside)).collect(),
        )
    }
}

/// Seconds and metres.
type Points = Vec<(f64, f64)>;

/// Told apart by most eyes (Okabe and Ito's palette).
fn color(scalar: ScalarName) -> Option<RGBColor> {
    Some(match scalar {
        ScalarName::F32 => RGBColor(213, 94, 0),
        ScalarName::I8F24 => RGBColor(0, 114, 178),
        ScalarName::I12F20 => RGBColor(86, 180, 233),
        ScalarName::I16F16 => RGBColor(0, 158, 115),
        ScalarName::I20F12 => RGBColor(204, 121, 167),
        ScalarName::F64 => return None,
    })
}

/// One digit at least, and no exponent.
fn decimal(x: &f64) -> String {
    let digits = -(x.log10() + 1e-9).floor();
    let digits = digits.max(0.0) as usize;
    format!("{x:.digits$}")
}

fn font(size: i32) -> TextStyle<'static> {
    (FONT, size).into_text_style(&SIZE).color(&BLACK)
}

/// Word by word: the space of the font is so narrow that "A throw" reads as "Athrow".
fn write<DB: DrawingBackend>(
    area: &Area<DB>,
    text: &str,
    size: i32,
    (mut x, y): (i32, i32),
) -> Drawn
where
    DB::ErrorType: 'static,
{
    let space = area.estimate_text_size(" ", &font(size))?.0;
    for word in text.split(' ') {
        area.draw_text(word, &font(size), (x, y))?;
        x += (area.estimate_text_size(word, &font(size))?.0 + 8 * space / 5) as i32;
    }
    Ok(())
}
