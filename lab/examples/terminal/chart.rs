//! The picture: two panels for each law, terminal speed and relative error on log axes; `f64`, far
//! below the others, has the lower one. A line for each scalar and group of methods, and its bound.

use std::error::Error;

use plotters::coord::CoordTranslate;
use plotters::element::DashedPathElement;
use plotters::prelude::*;

use crate::canvas::{Area, Drawn, font, line, px, write};
use crate::scene::Law;
use crate::series::{Cell, Group, Series, coinciding};

const TITLE: &str = "Terminal velocity: how far rounding keeps a falling body from it";
/// Height of most text, in pixels.
const TEXT: i32 = 16;
/// Ticks of the axis of speeds, m/s.
const TICKS: [f64; 7] = [0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0];
/// The ends of the axis of speeds.
const SPEEDS: [f64; 2] = [0.45, 55.0];
/// Powers of ten at the ends of the axes of errors, above and below.
const BANDS: [[i32; 2]; 2] = [[-8, -3], [-17, -12]];
/// Height of the upper panels, in pixels.
const UPPER: i32 = 310;

pub fn draw(area: &Area, all: &[Series]) -> Drawn {
    let groups = coinciding(all);
    let (head, below) = area.split_vertically(px(128));
    write(&head, TITLE, 22, (16, 22))?;
    write(&head, &caption(&groups), TEXT, (16, 52))?;
    let mut x = 16;
    for group in &groups {
        x = legend(&head, (x, 84), Style::of(group), &label(group, &groups))?;
    }
    let ends = [(px(x), px(84)), (px(x + 30), px(84))];
    head.draw(&dotted(ends.into_iter(), BLACK))?;
    write(&head, "derived bound", TEXT, (x + 38, 84))?;
    write(&head, "Linear drag, v_t = m g / k", TEXT, (84, 118))?;
    write(
        &head,
        "Quadratic drag, v_t = √(m g / c)",
        TEXT,
        (84 + 480, 118),
    )?;
    for (law, panel) in Law::BOTH.into_iter().zip(below.split_evenly((1, 2))) {
        let (upper, lower) = panel.split_vertically(px(UPPER));
        draw_panel(&upper, law, BANDS[0], &groups)?;
        draw_panel(&lower, law, BANDS[1], &groups)?;
    }
    Ok(())
}

fn caption(groups: &[Group]) -> String {
    let what = "Medians of 16 falls at 60 steps a second, each at its worst tick once settled.";
    match groups.iter().all(Group::is_of_all) {
        true => format!("{what} The four methods make the same bits. Bottom edge: 0."),
        false => what.to_string(),
    }
}

/// The scalar; with its methods where they differ.
fn label(group: &Group, groups: &[Group]) -> String {
    let scalar = &group.series.scalar;
    match groups.iter().all(Group::is_of_all) {
        true => scalar.clone(),
        false => format!("{scalar}, {}", group.label()),
    }
}

fn draw_panel(area: &Area, law: Law, band: [i32; 2], groups: &[Group]) -> Drawn {
    let [low, high] = band.map(|decade| 10_f64.powi(decade));
    let decades = (band[0]..=band[1]).map(|decade| 10_f64.powi(decade));
    let (x, y) = ((SPEEDS[0]..SPEEDS[1]).log_scale(), (low..high).log_scale());
    let lowest = band == BANDS[1];
    let mut chart = ChartBuilder::on(area)
        .margin(px(8))
        .margin_right(px(20))
        .x_label_area_size(px(if lowest { 48 } else { 8 }))
        .y_label_area_size(px(68))
        .build_cartesian_2d(
            x.with_key_points(TICKS.to_vec()),
            y.with_key_points(decades.collect()),
        )?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(line(BLACK.mix(0.12), 1))
        .axis_style(line(BLACK, 1))
        .set_all_tick_mark_size(px(5))
        .x_desc(if lowest {
            "terminal speed v_t, m/s"
        } else {
            ""
        })
        .y_desc(if lowest {
            ""
        } else {
            "relative error |v \u{2212} v_t| / v_t"
        })
        .x_label_formatter(&|x| if lowest { x.to_string() } else { String::new() })
        .y_label_formatter(&|y| format!("{y:.0e}").replace('-', "\u{2212}"))
        .label_style(font(TEXT - 2))
        .axis_desc_style(font(TEXT))
        .draw()?;
    let inside = |group: &&Group| group.bounds(law).all(|bound| low < bound && bound < high);
    for group in groups.iter().filter(inside) {
        let (style, cells) = (Style::of(group), &group.series.laws[law as usize]);
        let at = |error: fn(&Cell) -> f64| {
            let place = move |cell| (Cell::speed(cell), error(cell).max(low));
            cells.iter().map(place)
        };
        chart.draw_series([dotted(at(Cell::bound), style.color)])?;
        chart.draw_series(LineSeries::new(at(Cell::error), line(style.color, 1)))?;
        for place in at(Cell::error) {
            style.mark(chart.plotting_area(), place)?;
        }
    }
    Ok(())
}

fn dotted<I: Iterator + Clone>(places: I, color: RGBColor) -> DashedPathElement<I, i32> {
    DashedPathElement::new(places, px(2), px(3), line(color, 2))
}

/// The colour and mark of a scalar.
#[derive(Clone, Copy)]
struct Style {
    color: RGBColor,
    mark: char,
}

impl Style {
    /// Told apart by most eyes (Okabe and Ito's palette).
    fn of(group: &Group) -> Style {
        let (color, mark) = match group.series.scalar.as_str() {
            "f64" => (BLACK, 'x'),
            "f32" => (RGBColor(213, 94, 0), 'o'),
            "I16F16" => (RGBColor(0, 158, 115), '#'),
            "I12F20" => (RGBColor(86, 180, 233), '^'),
            _ => (RGBColor(0, 114, 178), '.'),
        };
        Style { color, mark }
    }

    fn mark<C: CoordTranslate>(
        self,
        area: &DrawingArea<BitMapBackend, C>,
        place: C::From,
    ) -> Drawn {
        let (at, fill, half) = (EmptyElement::at(place), self.color.filled(), px(4));
        match self.mark {
            'x' => area.draw(&(at + Cross::new((0, 0), half, line(self.color, 1))))?,
            'o' => area.draw(&(at + Circle::new((0, 0), half, fill)))?,
            '#' => area.draw(&(at + Rectangle::new([(-half, -half), (half, half)], fill)))?,
            '^' => area.draw(&(at + TriangleMarker::new((0, 0), px(5), fill)))?,
            _ => area.draw(&(at + Circle::new((0, 0), px(3), fill)))?,
        }
        Ok(())
    }
}

/// A mark on its line and what it stands for, at (`x`, `y`); returns where the next one may begin.
fn legend(
    area: &Area,
    (x, y): (i32, i32),
    style: Style,
    text: &str,
) -> Result<i32, Box<dyn Error>> {
    let ends = [(px(x), px(y)), (px(x + 30), px(y))];
    area.draw(&PathElement::new(ends, line(style.color, 1)))?;
    style.mark(area, (px(x + 15), px(y)))?;
    Ok(write(area, text, TEXT, (x + 38, y))? + 28)
}
