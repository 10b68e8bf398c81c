//! The picture: a panel for each scene, a line for each kind of body in its band, and guides.

use std::path::Path;

use plotters::prelude::*;

use crate::axes::{
    self, Axis, GREY, ORANGE, PURPLE, Panel, SKY, TEXT, VERMILION, grid, key, numbers,
};
use crate::canvas::{self, Area, Drawn, px, write};
use crate::table::Table;

const SIZE: (i32, i32) = (960, 820);
const BODIES: [(&str, RGBColor); 6] = [
    ("f32", VERMILION),
    ("f32 carried", ORANGE),
    ("I16F16", axes::GREEN),
    ("I12F20", SKY),
    ("I8F24", axes::BLUE),
    ("I8F24 carried", PURPLE),
];
const SCENES: [(&str, &str); 3] = [
    (
        "cruise",
        "Cruise at 0.5 to 3 m/s: a rounding that repeats, power 1",
    ),
    (
        "spring",
        "Springs of 1 m, 0.5 to 2.6 Hz: power 1/2, with a bias 1",
    ),
    (
        "oscillator",
        "Oscillator a = \u{2212}x \u{2212} x³: phase runs ahead, power 3/2",
    ),
];
const STEPS: [f64; 2] = [100.0, 1e7];
const ERRORS: [i32; 2] = [-10, 2];
const GUIDES: [(&str, f64); 4] = [("1/2", 0.5), ("1", 1.0), ("3/2", 1.5), ("2", 2.0)];
/// Where the guides begin.
const FROM: f64 = 1e-9;

pub fn draw(path: &Path, table: &Table) -> Drawn {
    canvas::save_sized(path, SIZE, |area| {
        let (head, below) = area.split_vertically(px(44));
        write(
            &head,
            "What rounding alone adds, against the number of steps at 60 Hz",
            22,
            (14, 22),
        )?;
        let panels = grid(&below, 2, 2);
        for ((scene, title), panel) in SCENES.into_iter().zip(&panels) {
            draw_scene(panel, scene, title, table)?;
        }
        panels.last().map_or(Ok(()), legend)
    })
}

fn draw_scene(area: &Area, scene: &str, title: &str, table: &Table) -> Drawn {
    let (head, below) = area.split_vertically(px(26));
    write(&head, title, TEXT, (30, 14))?;
    let x = Axis::decades("steps", [2, 7], 1);
    let y = Axis::decades("error, m", ERRORS, 2);
    let panel = Panel::new(&below, x, y)?;
    for (name, power) in GUIDES {
        guide(&panel, name, power)?;
    }
    for (body, color) in BODIES {
        let rows = table
            .rows
            .iter()
            .filter(|row| row[0] == scene && row[1] == body);
        let mut lines: [Vec<[f64; 2]>; 3] = Default::default();
        for row in rows {
            let values = numbers(row, 2)?;
            for (line, error) in lines.iter_mut().zip(&values[1..]) {
                line.push([values[0], *error]);
            }
        }
        let [low, median, high] = lines;
        panel.band(&low, &high, color.mix(0.13))?;
        panel.line(&median, color, 2)?;
        panel.dots(&median, color, px(3))?;
    }
    Ok(())
}

/// A power of the steps, as far as it stays in the panel.
fn guide(panel: &Panel, name: &str, power: f64) -> Drawn {
    let top = 10_f64.powi(ERRORS[1]);
    let end = STEPS[1].min(STEPS[0] * (top / FROM).powf(1.0 / power));
    let at = |steps: f64| [steps, FROM * (steps / STEPS[0]).powf(power)];
    panel.dashes(&[at(STEPS[0]), at(end)], GREY, 1)?;
    let [x, y] = at(end / 2.5);
    panel.text([x * 1.15, y / 2.5], name, GREY)
}

fn legend(area: &Area) -> Drawn {
    for ((body, color), i) in BODIES.into_iter().zip(0..) {
        key(area, (40, 60 + 28 * i), color, body)?;
    }
    let text = [
        "Lines: median of the starts, 16 of the cruise and 32",
        "of the others. Bands: nine tenths of them.",
        "Dashed: powers of the number of steps.",
        "Cruise: beside v t. The others: beside the same map",
        "in f64 with the coefficients of the type.",
        "An error as large as the orbit grows no more.",
    ];
    for (line, i) in text.into_iter().zip(0..) {
        write(area, line, TEXT, (40, 250 + 22 * i))?;
    }
    Ok(())
}
