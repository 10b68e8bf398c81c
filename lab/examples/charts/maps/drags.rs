//! The picture of drag alone: a strip for each method and kind, cells as they ran, limits as lines.

use std::path::Path;

use plotters::prelude::*;

use super::cells;
use super::drag_cell::{COLUMNS, Kind};
use super::law::{LAWS, Law, first_root};
use crate::axes::{GREY, TEXT, key, patch};
use crate::canvas::{self, Area, Drawn, line, px, write};
use crate::table::Table;

const SIZE: (i32, i32) = (960, 560);
const SWINGING: RGBColor = RGBColor(245, 215, 150);
const EXPLODING: RGBColor = RGBColor(213, 94, 0);
const MONOTONE: RGBColor = RGBColor(205, 225, 240);
const CLAMPED: RGBColor = RGBColor(170, 150, 150);
/// Where the strips of both laws begin, and how wide a cell is.
const LEFT: [i32; 2] = [190, 580];
const CELL: (i32, i32) = (11, 24);
const TOP: i32 = 104;
const PITCH: i32 = 34;
const LAST: i32 = 6;

pub fn draw(path: &Path, table: &Table) -> Drawn {
    canvas::save_sized(path, SIZE, |area| {
        let title = "Drag alone: a force explodes at its limit, a factor never does";
        write(area, title, 22, (14, 22))?;
        let mut x = 14;
        for (color, text) in [
            (MONOTONE, "falls"),
            (SWINGING, "falls, its sign swings"),
            (EXPLODING, "explodes"),
            (CLAMPED, "clamped at the end of the range"),
        ] {
            x = patch(area, (x, 54), color, text)?;
        }
        key(area, (x, 54), BLACK, "closed form")?;
        strips(
            area,
            0,
            "linear drag, k h / m",
            [Kind::Linear, Kind::LinearFactor],
            table,
        )?;
        let quadratic = [Kind::Quadratic, Kind::QuadraticFactor];
        strips(area, 1, "quadratic drag, h c |v| / m", quadratic, table)
    })
}

fn strips(area: &Area, side: usize, title: &str, kinds: [Kind; 2], table: &Table) -> Drawn {
    let left = LEFT[side];
    write(area, title, TEXT + 1, (left, 86))?;
    let mut y = TOP;
    for (law, i) in LAWS.iter().zip(0..) {
        y = TOP + i * PITCH;
        let method = format!("{:?}", law.scheme);
        if side == 0 {
            write(area, &method, TEXT - 1, (14, y + CELL.1 / 2))?;
        }
        strip(area, (left, y), kinds[0], law, table)?;
    }
    for (law, i) in LAWS.iter().zip(LAST..) {
        y = TOP + i * PITCH + 14;
        let method = format!("{:?}", law.scheme);
        if side == 0 {
            write(
                area,
                &format!("{method}, exact"),
                TEXT - 1,
                (14, y + CELL.1 / 2),
            )?;
        }
        strip(area, (left, y), kinds[1], law, table)?;
    }
    scale(area, (left, y + CELL.1 + 4), kinds[0])
}

fn strip(area: &Area, (x, y): (i32, i32), kind: Kind, law: &Law, table: &Table) -> Drawn {
    let method = format!("{:?}", law.scheme);
    let courses = cells(table, &method, kind.name(), "").unwrap_or_default();
    for (course, i) in courses.chars().zip(0..) {
        let color = match course {
            '.' => MONOTONE,
            '~' => SWINGING,
            '#' => EXPLODING,
            _ => CLAMPED,
        };
        let corners = [
            (px(x + i * CELL.0), px(y)),
            (px(x + (i + 1) * CELL.0 - 1), px(y + CELL.1)),
        ];
        area.draw(&Rectangle::new(corners, color.filled()))?;
    }
    for limit in [swings(kind, law), kind.limit(law)] {
        if limit.is_finite() {
            let at = place(kind, x, limit);
            area.draw(&PathElement::new(
                [(at, px(y - 3)), (at, px(y + CELL.1 + 3))],
                line(BLACK, 2),
            ))?;
        }
    }
    Ok(())
}

/// Where the sign begins to swing.
fn swings(kind: Kind, law: &Law) -> f64 {
    first_root(|rate| kind.factor(law, rate) >= 0.0, 6.0)
}

/// Of a rate, in the pixels that are drawn: the middle of a column is its rate.
fn place(kind: Kind, left: i32, rate: f64) -> i32 {
    let pitch = (kind.column(1) / kind.column(0)).ln();
    let column = (rate / kind.column(0)).ln() / pitch + 0.5;
    px(left) + (column * f64::from(px(CELL.0))) as i32
}

fn scale(area: &Area, (left, y): (i32, i32), kind: Kind) -> Drawn {
    let last = kind.column(COLUMNS - 1);
    for rate in [0.01, 0.1, 1.0, 10.0, 100.0, 1000.0]
        .into_iter()
        .filter(|&r| r <= 1.01 * last)
    {
        let at = place(kind, left, rate);
        area.draw(&PathElement::new(
            [(at, px(y)), (at, px(y + 5))],
            line(GREY, 1),
        ))?;
        let text = rate.to_string();
        write(
            area,
            &text,
            TEXT - 2,
            (at / px(1) - 4 * text.len() as i32, y + 14),
        )?;
    }
    Ok(())
}
