//! The head of a chart of work and precision: its title and what colours, marks and dashes mean.

use plotters::prelude::*;

use crate::canvas::{Area, Drawn, line, px, write};
use crate::lines::Line;
use crate::look::{DARK, Look};

/// Kinds of bodies, as tables name them.
pub const BODIES: [&str; 5] = ["f32", "I16F16", "I8F24", "f32 carried", "I8F24 carried"];
/// Height of the text, in pixels.
const TEXT: i32 = 14;
/// The left edge.
const LEFT: i32 = 16;
/// The middles of the legend's lines.
const COLORS: i32 = 70;
const MARKS: i32 = 95;

pub fn draw(area: &Area, title: &str, lines: &[Line]) -> Drawn {
    write(area, title, 21, (LEFT, 20))?;
    let what = "Stairs: the Pareto front. In colour what touches it, with the 5 to 95 % band of \
                16 starts and their median; grey: what never does.";
    write(area, what, TEXT, (LEFT, 45))?;
    colors(area, lines)?;
    marks(area)
}

fn colors(area: &Area, lines: &[Line]) -> Drawn {
    let mut x = LEFT;
    let mut named: Vec<[&str; 2]> = Vec::new();
    for at in lines.iter().filter(|line| line.first) {
        if !named.contains(&at.kind()) {
            named.push(at.kind());
            let style = line(Look::new(at.name).color, 4);
            let ends = [x, x + 24].map(|x| (px(x), px(COLORS)));
            area.draw(&PathElement::new(ends, style))?;
            x = write(area, &at.kind().join(", "), TEXT, (x + 30, COLORS))? + 18;
        }
    }
    Ok(())
}

fn marks(area: &Area) -> Drawn {
    let mut x = LEFT;
    for body in BODIES {
        let look = Look::new(["", "", body]).with_color(DARK);
        look.path(area, &[x, x + 46].map(|x| (px(x), px(MARKS))), 2)?;
        look.mark(area, (px(x + 14), px(MARKS)), true)?;
        look.mark(area, (px(x + 32), px(MARKS)), false)?;
        x = write(area, body, TEXT, (x + 52, MARKS))? + 18;
    }
    write(
        area,
        "filled: 60, 120, 240 of 15 to 960 Hz",
        TEXT,
        (x, MARKS),
    )?;
    Ok(())
}
