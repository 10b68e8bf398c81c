//! The picture of a table of work and precision, for one core: work and error on log axes, a line for each
//! method, way to state forces and body.
//!
//! In colour are the lines of which a point is on the Pareto front, with their bands; all others are grey,
//! and named once for each method. What failed is a cross on the top edge. Dotted is the least median that
//! any line of a body reaches: where its lines turn flat, that is its rounding.

use std::path::Path;

use plotters::element::DashedPathElement;
use plotters::prelude::*;

use crate::canvas::{self, Area, Drawn, line, px, write};
use crate::cost::Core;
use crate::figures::Row;
use crate::frame::Frame;
use crate::head::{self, BODIES};
use crate::labels::Labels;
use crate::lines::{Line, lines};
use crate::look::{At, DARK, GREY, Look, NAMES};
use crate::pareto::{Point, stairs};
use crate::starts::Plan;
use crate::table::Table;

/// Rates whose marks are filled, Hz.
const MARKED: [u32; 3] = [60, 120, 240];
/// Height of most text, in pixels.
const TEXT: i32 = 15;

/// Two pictures: `<name>-m0.png` and `<name>-m4f.png`.
pub fn draw(folder: &Path, table: &Table) -> Drawn {
    let rows = Row::all(table)?;
    let plan = Plan::of(table.name.trim_start_matches("work-"));
    for core in Core::ALL {
        let path = folder.join(format!("{}-{}.png", table.name, core.short()));
        let panel = Panel::new(core, &plan, &rows);
        canvas::save(&path, |area| panel.draw(area))?;
    }
    Ok(())
}

struct Panel<'a> {
    core: Core,
    plan: &'a Plan,
    lines: Vec<Line<'a>>,
    frame: Frame,
}

impl<'a> Panel<'a> {
    fn new(core: Core, plan: &'a Plan, rows: &'a [Row]) -> Self {
        let least = |of: &dyn Fn(&Row) -> f64| rows.iter().map(of).fold(f64::INFINITY, f64::min);
        let work = |row: &Row| row.work(core);
        let most = rows.iter().map(work).fold(0.0, f64::max);
        let low = least(&|row| row.errors[0]);
        let frame = Frame {
            x: [least(&work) * 0.8, most * 1.25],
            y: [low * 0.5, plan.size],
            left: 84,
            right: 850,
            top: 140,
            bottom: 586,
        };
        let lines = lines(core, plan.size, rows);
        Panel {
            core,
            plan,
            lines,
            frame,
        }
    }

    fn draw(&self, area: &Area) -> Drawn {
        let title = format!(
            "Work and precision: {}, {}",
            self.plan.title(),
            self.core.name()
        );
        head::draw(area, &title, &self.lines)?;
        let work = format!(
            "instructions per body and simulated second, {}",
            self.core.name()
        );
        let error = format!("rms error of the last second, {}", self.plan.unit());
        self.frame.draw(area, [&work, &error])?;
        for line in self.lines.iter().filter(|line| !line.first) {
            let look = Look::new(line.name).with_color(GREY);
            look.path(area, &self.places(line), 1)?;
        }
        self.floors(area)?;
        for line in self.first() {
            self.band(area, line)?;
        }
        area.draw(&PathElement::new(self.stairs(), line(BLACK, 1)))?;
        for line in self.first() {
            let look = Look::new(line.name);
            look.path(area, &self.places(line), 2)?;
            for (row, at) in line.rows.iter().zip(self.places(line)) {
                look.mark(area, at, MARKED.contains(&row.rate))?;
            }
        }
        self.names(area)?;
        self.crosses(area)
    }

    fn first(&self) -> impl Iterator<Item = &Line<'a>> {
        self.lines.iter().filter(|line| line.first)
    }

    /// Where the points of a line are that did not fail.
    fn places(&self, line: &Line) -> Vec<At> {
        line.points
            .iter()
            .map(|&point| self.frame.at(point))
            .collect()
    }

    fn stairs(&self) -> Vec<At> {
        let front: Vec<Point> = self
            .lines
            .iter()
            .flat_map(|line| line.front.clone())
            .collect();
        let corners = stairs(&front, self.frame.y[1], self.frame.x[1]);
        corners
            .into_iter()
            .map(|point| self.frame.at(point))
            .collect()
    }

    /// The least median of each body, with its name on the right, names apart.
    fn floors(&self, area: &Area) -> Drawn {
        let least = |body: &str| {
            let points = self
                .lines
                .iter()
                .filter(|line| line.name[2] == body)
                .flat_map(|line| &line.points);
            points.map(|point| point.1).fold(f64::INFINITY, f64::min)
        };
        let mut floors: Vec<(f64, &str)> = BODIES.map(|body| (least(body), body)).to_vec();
        floors.retain(|floor| floor.0.is_finite());
        floors.sort_by(|a, b| b.0.total_cmp(&a.0));
        let (left, right) = (px(self.frame.left), px(self.frame.right));
        let mut next = self.frame.top + 8;
        for (error, body) in floors {
            let (_, y) = self.frame.at((self.frame.x[0], error));
            let dots = DashedPathElement::new([(left, y), (right, y)], px(2), px(4), line(DARK, 1));
            area.draw(&dots)?;
            let place = (y / px(1)).max(next);
            area.draw(&PathElement::new(
                [(right, y), (right + px(8), px(place))],
                line(DARK, 1),
            ))?;
            write(area, body, TEXT - 2, (self.frame.right + 11, place))?;
            next = place + 15;
        }
        Ok(())
    }

    fn band(&self, area: &Area, line: &Line) -> Drawn {
        let edge = |i: usize| {
            let known = line
                .rows
                .iter()
                .filter(move |row| row.errors[2].is_finite());
            known.map(move |row| self.frame.at((row.work(self.core), row.errors[i])))
        };
        let mut corners: Vec<At> = edge(0).collect();
        corners.extend(edge(2).rev());
        area.draw(&Polygon::new(corners, Look::new(line.name).color.mix(0.13)))?;
        Ok(())
    }

    /// Of each method and way to state forces that has no colour, once, beside one of its lines.
    fn names(&self, area: &Area) -> Drawn {
        let frame = &self.frame;
        let room = [frame.left, frame.top + 6, frame.right, frame.bottom];
        let mut labels = Labels::new(room.map(px));
        labels.keep_off(&self.stairs());
        let mut named: Vec<[&str; 2]> = Vec::new();
        for line in self.first() {
            labels.keep_off(&self.places(line));
            named.push(line.kind());
        }
        for Line { name, .. } in &self.lines {
            let kind = [name[0], name[1]];
            if !named.contains(&kind) {
                named.push(kind);
                let same = self.lines.iter().filter(|line| line.kind() == kind);
                let mut places: Vec<At> = same.flat_map(|line| self.places(line)).collect();
                places.sort_unstable();
                // Where every run failed there is no line: the crosses name it.
                let drawn = !places.is_empty();
                if drawn && !labels.write(area, &kind.join(", "), (TEXT - 3, NAMES), &places)? {
                    return Err(format!("no room for the name of {}", kind.join(", ")).into());
                }
            }
        }
        Ok(())
    }

    /// What failed, on the top edge, and a word for it.
    fn crosses(&self, area: &Area) -> Drawn {
        let mut failed: Vec<&str> = Vec::new();
        for Line {
            name,
            failed: all,
            first,
            ..
        } in &self.lines
        {
            let color = if *first { Look::new(*name).color } else { DARK };
            for &work in all {
                let at = self.frame.at((work, self.frame.y[1]));
                area.draw(&Cross::new(at, px(4), line(color, 1)))?;
            }
            if !all.is_empty() && !failed.contains(&name[0]) {
                failed.push(name[0]);
            }
        }
        let (size, unit) = (self.plan.size, self.plan.unit());
        let text = match failed.is_empty() {
            true => format!("No start left its range, or was wrong by more than {size} {unit}"),
            false => {
                let who = failed.join(", ");
                format!(
                    "\u{00d7} some start left its range, or is wrong by more than {size} {unit}: {who}"
                )
            }
        };
        let text = text + ". Dotted: the least median of each body.";
        write(
            area,
            &text,
            TEXT - 2,
            (self.frame.left, self.frame.top - 18),
        )?;
        Ok(())
    }
}
