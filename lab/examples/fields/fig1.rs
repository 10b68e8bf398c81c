//! Fig. 1: the slope field of dy/dx = 2x with its parabolas, and every method over it.

use std::error::Error;

use crate::canvas::{Area, Drawn, px, write};
use crate::chart::{
    Axes, BLUE, Chart, GREEN, Mark, Style, TEXT, VERMILION, curve, legend, slope_field, trace,
};
use crate::figures::coinciding;
use crate::flight::{MethodName, Run};

const TITLE: &str = "Fig. 1   Slope field of dy/dx = 2x and its parabolas y = x² + c";
const CAPTION: &str = "The methods from (\u{2212}2, 4) with steps of 1/2 in x. \
                       Thick: the exact solution, c = 0.";
/// Of the parabolas; each is named at the right edge.
const CONSTANTS: [i32; 7] = [-4, -3, -2, -1, 0, 1, 2];

pub fn draw(area: &Area, runs: &[Run]) -> Drawn {
    let (head, below) = area.split_vertically(px(100));
    write(&head, TITLE, 22, (16, 22))?;
    write(&head, CAPTION, TEXT, (16, 52))?;
    let mut chart = axes().draw(&below)?;
    slope_field(&mut chart, |x, _| 2.0 * x)?;
    for c in CONSTANTS {
        let parabola = |x: f64| x * x + f64::from(c);
        curve(&mut chart, c == 0, parabola)?;
        let end = chart.x_range().end;
        name(&chart, area, c, (end, parabola(end)))?;
    }
    methods(&mut chart, &head, runs)?;
    Ok(())
}

fn axes() -> Axes {
    Axes {
        x: -2.5..2.5,
        y: -4.6..8.6,
        names: ["x", "y"],
        labels: [11, 8],
        right: 64,
    }
}

/// Behind the right end of a parabola.
fn name(chart: &Chart, area: &Area, c: i32, end: (f64, f64)) -> Result<i32, Box<dyn Error>> {
    let (x, y) = chart.backend_coord(&end);
    let text = format!("c = {c}").replace('-', "\u{2212}");
    write(area, &text, TEXT - 2, (x / px(1) + 8, y / px(1)))
}

fn methods(chart: &mut Chart, head: &Area, runs: &[Run]) -> Drawn {
    let mut x = 16;
    for group in coinciding(runs) {
        let style = style(group.run.method);
        trace(chart, group.run, style)?;
        x = legend(head, (x, 82), style, &group.label())?;
    }
    Ok(())
}

fn style(method: MethodName) -> Style {
    let (color, mark) = match method {
        MethodName::Euler => (VERMILION, Mark::Disc),
        MethodName::SemiImplicitEuler => (BLUE, Mark::Triangle),
        MethodName::ConstantAcceleration | MethodName::Verlet => (GREEN, Mark::Square),
    };
    Style { color, mark }
}
