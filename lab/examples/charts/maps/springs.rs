//! The picture of springs: a panel for each method, cells as they ran, and the closed forms as lines.

use std::path::Path;

use plotters::prelude::*;

use super::law::{DRAGS, Drag, LAWS, Law, stable};
use super::{ROWS, cells, drag_name, run, zeta};
use crate::axes::{Axis, Panel, TEXT, grid, key, patch};
use crate::canvas::{self, Area, Drawn, px, write};
use crate::table::Table;

const SIZE: (i32, i32) = (960, 700);
const BOTH: RGBColor = RGBColor(205, 225, 240);
const EXACT: RGBColor = RGBColor(190, 230, 200);
const EXPLICIT: RGBColor = RGBColor(250, 220, 170);
const LINES: [RGBColor; 2] = [BLACK, RGBColor(0, 110, 60)];
/// Points of a panel in which the closed form is asked.
const FINE: [usize; 2] = [480, 400];

pub fn draw(path: &Path, table: &Table) -> Drawn {
    canvas::save_sized(path, SIZE, |area| {
        let (head, below) = area.split_vertically(px(88));
        let title = "Where a damped spring stays bounded, measured and by the closed form";
        write(&head, title, 22, (14, 22))?;
        let mut x = 14;
        for (color, text) in [
            (BOTH, "bounded for 10,000 steps"),
            (EXACT, "with exact drag only"),
            (EXPLICIT, "with explicit drag only"),
        ] {
            x = patch(&head, (x, 52), color, text)?;
        }
        write(&head, "white: grows", TEXT - 1, (x, 52))?;
        let x = key(&head, (14, 76), LINES[0], "closed form, explicit drag")?;
        let x = key(&head, (x, 76), LINES[1], "closed form, exact drag")?;
        write(&head, "cells: runs in I16F16", TEXT - 1, (x, 76))?;
        for (law, panel) in LAWS.iter().zip(grid(&below, 2, 3)) {
            draw_law(&panel, law, table)?;
        }
        Ok(())
    })
}

fn draw_law(area: &Area, law: &Law, table: &Table) -> Drawn {
    let (head, below) = area.split_vertically(px(24));
    let method = format!("{:?}", law.scheme);
    write(&head, &method, TEXT + 1, (66, 12))?;
    // Half a cell beyond the outermost.
    let [wide, high] = [ratio(run::column), ratio(zeta)].map(f64::sqrt);
    let columns = run::columns().count();
    let ends = |at: fn(usize) -> f64, last, half| [at(0) / half, at(last) * half];
    let x = ends(run::column, columns - 1, wide);
    let y = ends(zeta, ROWS - 1, high);
    let x = Axis::log("ω h", x, &[0.1, 0.2, 0.5, 1.0, 2.0, 5.0]);
    let y = Axis::log("damping ratio ζ", y, &[0.01, 0.1, 1.0, 5.0]);
    let panel = Panel::new(&below, x.clone(), y.clone())?;
    for row in 0..ROWS {
        let name = format!("{:.4}", zeta(row));
        let [explicit, exact] = DRAGS.map(|drag| cells(table, &method, drag_name(drag), &name));
        let (Some(explicit), Some(exact)) = (explicit, exact) else {
            continue;
        };
        for (column, (explicit, exact)) in explicit.chars().zip(exact.chars()).enumerate() {
            let color = match (explicit, exact) {
                ('.', '.') => BOTH,
                ('.', _) => EXPLICIT,
                (_, '.') => EXACT,
                _ => continue,
            };
            let (q, zeta) = (run::column(column), zeta(row));
            // A gap beside each cell, so that one can count them.
            let [wide, high] = [wide, high].map(|half| half.powf(0.85));
            let corners = [[q / wide, zeta / high], [q * wide, zeta * high]];
            panel.cell(corners, color)?;
        }
    }
    for (drag, color) in DRAGS.into_iter().zip(LINES) {
        panel.dots(&border(law, drag, &x, &y), color, px(1))?;
    }
    Ok(())
}

/// How far a value of the grid is from the one before.
fn ratio(at: fn(usize) -> f64) -> f64 {
    at(1) / at(0)
}

/// Points beside which the closed form changes its mind.
fn border(law: &Law, drag: Drag, x: &Axis, y: &Axis) -> Vec<[f64; 2]> {
    let at = |i: usize, j: usize| {
        let share = |k: usize, of: usize| (k as f64 + 0.5) / of as f64;
        [x.value(share(i, FINE[0])), y.value(share(j, FINE[1]))]
    };
    let holds = |i, j| {
        let [q, zeta] = at(i, j);
        stable((law.spring)(drag, q, zeta))
    };
    let mut points = vec![];
    for i in 0..FINE[0] - 1 {
        for j in 0..FINE[1] - 1 {
            let here = holds(i, j);
            if here != holds(i + 1, j) || here != holds(i, j + 1) {
                points.push(at(i, j));
            }
        }
    }
    points
}
