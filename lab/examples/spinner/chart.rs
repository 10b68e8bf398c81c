//! The picture: a lane for each body, its outline at every stroke of a stroboscope, the path of its centre, and
//! the push.

use fixstep::rigid::Centre;
use fixstep::{Rigid, Vec2};
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;

use crate::canvas::{Area, Drawn, SIZE, font, line, px, write};
use crate::flight::placed;
use crate::lane::{BELOW, Lane, NOZZLE};

/// Told apart by most eyes (Okabe and Ito's palette).
const BLUE: RGBColor = RGBColor(0, 114, 178);
const VERMILION: RGBColor = RGBColor(213, 94, 0);
const GREY: RGBColor = RGBColor(120, 120, 120);

/// Ticks from stroke to stroke: 0.75 s.
const STROKE: usize = 90;
/// Height of most text, in pixels.
const TEXT: i32 = 16;
const HEAD: i32 = 74;
const MARGIN: i32 = 16;
/// Room for the labels of the x axis.
const LABELS: i32 = 46;
/// Ends of the x axis, m.
const ACROSS: [f64; 2] = [-0.9, 12.0];
/// Where the lanes are, m above the lower edge.
const HEIGHTS: [f64; 5] = [6.25, 5.0, 3.75, 2.5, 1.15];

type Plane = Cartesian2d<RangedCoordf64, RangedCoordf64>;
type Chart<'a, 'b> = ChartContext<'a, BitMapBackend<'b>, Plane>;

pub fn draw<C: Centre>(area: &Area, lanes: &[(Lane, Vec<Rigid<C>>)]) -> Drawn {
    let (head, below) = area.split_vertically(px(HEAD));
    write(
        &head,
        "Bodies that turn, drawn every 0.75 s",
        22,
        (MARGIN, 22),
    )?;
    legend(&head)?;
    let mut chart = plane(&below)?;
    for ((lane, seen), height) in lanes.iter().zip(HEIGHTS) {
        draw_lane(&mut chart, *lane, seen, Vec2::new(0.0, height))?;
        let (x, y) = chart.backend_coord(&(ACROSS[0], height + 0.66));
        write(area, lane.name(), TEXT, (x / px(1), y / px(1)))?;
    }
    Ok(())
}

fn legend(head: &Area) -> Drawn {
    let mut x = MARGIN;
    for (color, text) in [
        (VERMILION, "push"),
        (GREY, "path of the centre"),
        (BLUE, "outline, a dot on one corner"),
    ] {
        head.draw(&PathElement::new(
            [(px(x), px(50)), (px(x + 26), px(50))],
            line(color, 2),
        ))?;
        x = write(head, text, TEXT, (x + 34, 50))? + 28;
    }
    Ok(())
}

/// Both axes have one scale.
fn plane<'a, 'b>(area: &'a Area<'b>) -> Result<Chart<'a, 'b>, Box<dyn std::error::Error>> {
    let (wide, high) = (SIZE.0 - 2 * MARGIN, SIZE.1 - HEAD - LABELS - MARGIN);
    let up = (ACROSS[1] - ACROSS[0]) * f64::from(high) / f64::from(wide);
    let mut chart = ChartBuilder::on(area)
        .margin(px(MARGIN))
        .margin_top(0)
        .x_label_area_size(px(LABELS))
        .build_cartesian_2d(ACROSS[0]..ACROSS[1], 0.0..up)?;
    chart
        .configure_mesh()
        .disable_mesh()
        .axis_style(line(BLACK, 1))
        .x_desc("x, m")
        .x_labels(13)
        .x_label_formatter(&|x| format!("{x:.0}"))
        .label_style(font(TEXT - 2))
        .axis_desc_style(font(TEXT))
        .draw()?;
    Ok(chart)
}

fn draw_lane<C: Centre>(
    chart: &mut Chart,
    lane: Lane,
    seen: &[Rigid<C>],
    start: Vec2<f64>,
) -> Drawn {
    let shown = |point: Vec2<f64>| (start.x + point.x, start.y + point.y);
    let outline = lane.outline();
    for body in seen.iter().step_by(STROKE) {
        let corners: Vec<_> = placed(body, &outline).into_iter().map(shown).collect();
        let around = corners.iter().chain(&corners[..1]).copied();
        chart.draw_series(LineSeries::new(around, line(BLUE, 1)))?;
        let dot = Circle::new(corners[0], px(3), BLUE.filled());
        chart.draw_series([dot])?;
    }
    let path = seen.iter().map(|body| shown(body.position().to_f64()));
    chart.draw_series(LineSeries::new(path, line(GREY, 2)))?;
    for [tail, head] in pushes(lane, seen) {
        arrow(chart, shown(tail), shown(head))?;
    }
    Ok(())
}

/// Tail and head of each arrow: the impulse at the start, or the thruster while it burns.
fn pushes<C: Centre>(lane: Lane, seen: &[Rigid<C>]) -> Vec<[Vec2<f64>; 2]> {
    let from = |x: f64, y: f64, length: f64| [Vec2::new(x - length, y), Vec2::new(x, y)];
    match lane {
        Lane::Through => vec![from(-0.4, 0.0, 0.4)],
        Lane::OffCentre | Lane::Braked | Lane::Driven => vec![from(-0.4, BELOW.to_f64(), 0.4)],
        Lane::Gear => {
            let flame = from(0.0, NOZZLE.to_f64(), 0.35);
            let burning = seen.iter().take(crate::lane::BURN as usize).step_by(STROKE);
            burning
                .map(|gear| placed(gear, &flame))
                .map(|ends| [ends[0], ends[1]])
                .collect()
        }
    }
}

fn arrow(chart: &mut Chart, tail: (f64, f64), head: (f64, f64)) -> Drawn {
    let (dx, dy) = (head.0 - tail.0, head.1 - tail.1);
    let long = dx.hypot(dy);
    let barb = |side: f64| {
        let (along, across) = (0.13 / long, side * 0.07 / long);
        (
            head.0 - along * dx - across * dy,
            head.1 - along * dy + across * dx,
        )
    };
    let style = line(VERMILION, 2);
    chart.draw_series(LineSeries::new([tail, head], style))?;
    chart.draw_series([Polygon::new(
        [head, barb(1.0), barb(-1.0)],
        VERMILION.filled(),
    )])?;
    Ok(())
}
