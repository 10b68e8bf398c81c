//! The lines of a chart of work and precision: the rows of one method, way to state forces and body.

use crate::cost::Core;
use crate::figures::Row;
use crate::pareto::{Point, front};

pub struct Line<'a> {
    pub name: [&'a str; 3],
    /// The rows whose median did not fail, and where they are.
    pub rows: Vec<&'a Row>,
    pub points: Vec<Point>,
    /// The points that are on the front.
    pub front: Vec<Point>,
    /// Whether there is one.
    pub first: bool,
    /// Work of the rows of which a start or more failed.
    pub failed: Vec<f64>,
}

impl<'a> Line<'a> {
    /// Method and forces.
    pub fn kind(&self) -> [&'a str; 2] {
        [self.name[0], self.name[1]]
    }
}

/// All lines of a scene of that size, on one core.
pub fn lines<'a>(core: Core, size: f64, rows: &'a [Row]) -> Vec<Line<'a>> {
    let points: Vec<Point> = rows.iter().map(|row| row.point(core, size)).collect();
    let mut lines: Vec<Line> = Vec::new();
    for ((row, on), point) in rows.iter().zip(front(&points)).zip(&points) {
        let place = lines.iter().position(|line| line.name == row.line());
        let place = place.unwrap_or_else(|| {
            lines.push(Line {
                name: row.line(),
                rows: Vec::new(),
                points: Vec::new(),
                front: Vec::new(),
                first: false,
                failed: Vec::new(),
            });
            lines.len() - 1
        });
        let line = &mut lines[place];
        if point.1.is_finite() {
            line.rows.push(row);
            line.points.push(*point);
        }
        line.failed.extend((row.failed > 0).then_some(point.0));
        line.first |= on;
        line.front.extend(on.then_some(*point));
    }
    lines
}
