//! Fig. 2: the slope field of dv/dt = -v/m with its decaying curves, and every method over it.
//!
//! On the left at a step that decays too; on the right beside one that changes sign each time and
//! one that grows without bound: `1 - k h/m` is 1/2, -1/2 and -3/2.

use std::ops::Range;

use crate::canvas::{Area, Drawn, px, write};
use crate::chart::{
    Axes, BLUE, Chart, GREEN, Mark, Style, TEXT, VERMILION, curve, legend, slope_field, trace,
};
use crate::figures::{SECONDS, V0, coinciding};
use crate::flight::Run;

const TITLE: &str =
    "Fig. 2   Slope field of dv/dt = \u{2212}v/m and its curves v = v0 exp(\u{2212}t/m), m = 1 kg";
const CAPTION: &str = "Explicit steps under a drag of k = 1 kg/s. \
                       Thick: the exact solution from v0 = 2 m/s.";
const LEFT: &str = "Curves from several v0, and k h/m = 0.5";
const RIGHT: &str = "k h/m = 0.5 decays, 1.5 changes sign, 2.5 grows";
/// Starts of the curves on the left, m/s.
const STARTS: [f64; 8] = [2.0, 1.5, 1.0, 0.5, -0.5, -1.0, -1.5, -2.0];

pub fn draw(area: &Area, runs: &[Run]) -> Drawn {
    let (head, below) = area.split_vertically(px(128));
    write(&head, TITLE, 22, (16, 22))?;
    write(&head, CAPTION, TEXT, (16, 52))?;
    let panels = below.split_evenly((1, 2));
    write(&head, LEFT, TEXT, (64, 120))?;
    write(&head, RIGHT, TEXT, (64 + 480, 120))?;
    let mut left = axes(5.0, -2.2..2.2).draw(&panels[0])?;
    let mut right = axes(SECONDS + 0.2, -7.5..5.5).draw(&panels[1])?;
    field(&mut left, &STARTS)?;
    field(&mut right, &[V0])?;
    let mut x = 16;
    for group in coinciding(runs) {
        let (step, style) = (group.run.step, style(group.run.step));
        if step < 1.0 {
            trace(&mut left, group.run, style)?;
        }
        trace(&mut right, group.run, style)?;
        let label = format!("h = {step} s, {}", group.label());
        x = legend(&head, (x, 82), style, &label)?;
    }
    Ok(())
}

fn axes(seconds: f64, y: Range<f64>) -> Axes {
    Axes {
        x: 0.0..seconds,
        y,
        names: ["time t, s", "velocity v, m/s"],
        labels: [8, 10],
        right: 20,
    }
}

/// The slopes, and the curves from `starts`.
fn field(chart: &mut Chart, starts: &[f64]) -> Drawn {
    slope_field(chart, |_, v| -v)?;
    for &v0 in starts {
        curve(chart, v0 == V0, |t| v0 * (-t).exp())?;
    }
    Ok(())
}

fn style(step: f64) -> Style {
    let (color, mark) = match step {
        ..1.0 => (BLUE, Mark::Disc),
        ..2.0 => (GREEN, Mark::Square),
        _ => (VERMILION, Mark::Triangle),
    };
    Style { color, mark }
}
