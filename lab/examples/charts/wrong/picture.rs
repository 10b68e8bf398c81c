//! The picture: eight panels, two abreast; a title says what one sees.

use std::path::Path;

use super::panels::{self, Spec};
use super::points;
use crate::axes::{GREY, Panel, grid, key};
use crate::canvas::{self, Area, Drawn, px, write};
use crate::table::Table;

const SIZE: (i32, i32) = (960, 1330);

pub fn draw(path: &Path, table: &Table) -> Drawn {
    canvas::save_sized(path, SIZE, |area| {
        let (head, below) = area.split_vertically(px(40));
        write(
            &head,
            "What goes wrong in simulations, and what this crate does",
            22,
            (14, 22),
        )?;

        for (spec, panel) in panels::all(table).into_iter().zip(grid(&below, 4, 2)) {
            draw_panel(&panel, spec, table)?;
        }
        Ok(())
    })
}

fn draw_panel(area: &Area, spec: Spec, table: &Table) -> Drawn {
    let (head, below) = area.split_vertically(px(50));
    write(&head, &spec.title, 16, (14, 14))?;
    let [x, y] = spec.axes;
    let panel = Panel::new(&below, x, y)?;
    let mut at = 14;
    for (name, lines, color) in spec.lines {
        at = key(&head, (at, 38), color, name)?;
        for line in lines {
            let points = points(table, spec.name, line);
            match color == GREY {
                true => panel.dashes(&points, GREY, 3)?,
                false => panel.line(&points, color, 2)?,
            }
        }
    }
    Ok(())
}
