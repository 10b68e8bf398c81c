//! A row of a chart of work and precision, as figures and as text.

use crate::cost::Core;
use crate::pareto::Point;
use crate::table::Table;

pub const HEADER: [&str; 10] = [
    "method",
    "forces",
    "body",
    "rate_hz",
    "m0_instructions_per_step",
    "m4f_instructions_per_step",
    "error_m_5_percent",
    "error_m_median",
    "error_m_95_percent",
    "failed_starts",
];
/// The same with errors in metres or in turns.
pub fn header(unit: &str) -> Vec<&'static str> {
    let mut header = HEADER.to_vec();
    if unit == "turns" {
        header[6..9].copy_from_slice(&[
            "error_turns_5_percent",
            "error_turns_median",
            "error_turns_95_percent",
        ]);
    }
    header
}

/// Columns that name a row.
pub const KEYS: usize = 4;

#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    pub method: String,
    pub forces: String,
    pub body: String,
    pub rate: u32,
    /// Instructions per body and step, of each core.
    pub costs: [f64; 2],
    /// Errors at 5, 50 and 95 % of the starts, m or turns.
    pub errors: [f64; 3],
    /// Starts that left the range, or whose error is above the size of the scene.
    pub failed: usize,
}

impl Row {
    /// Of the errors of all starts; one above `size` has failed.
    pub fn of(
        [method, forces, body]: [&str; 3],
        rate: u32,
        costs: [f64; 2],
        errors: &[f64],
        size: f64,
    ) -> Row {
        Row {
            method: method.into(),
            forces: forces.into(),
            body: body.into(),
            rate,
            costs,
            errors: [0.05, 0.5, 0.95].map(|part| quantile(errors, part)),
            failed: errors.len() - errors.iter().filter(|&&error| error <= size).count(),
        }
    }

    pub fn cells(&self) -> Vec<String> {
        let mut cells = vec![self.method.clone(), self.forces.clone(), self.body.clone()];
        cells.push(self.rate.to_string());
        cells.extend(self.costs.map(|cost| format!("{cost:.1}")));
        cells.extend(self.errors.map(|error| format!("{error:.4e}")));
        cells.push(self.failed.to_string());
        cells
    }

    /// All rows of a table.
    pub fn all(table: &Table) -> Result<Vec<Row>, String> {
        let row = |cells: &Vec<String>| {
            Row::read(cells).ok_or_else(|| format!("{}: {cells:?}", table.name))
        };
        table.rows.iter().map(row).collect()
    }

    fn read(cells: &[String]) -> Option<Row> {
        let number = |i: usize| cells.get(i)?.parse::<f64>().ok();
        Some(Row {
            method: cells.first()?.clone(),
            forces: cells.get(1)?.clone(),
            body: cells.get(2)?.clone(),
            rate: cells.get(3)?.parse().ok()?,
            costs: [number(4)?, number(5)?],
            errors: [number(6)?, number(7)?, number(8)?],
            failed: cells.get(9)?.parse().ok()?,
        })
    }

    /// Instructions per body and simulated second. A step is counted at 60 Hz; nothing in a `Step`
    /// depends on its rate.
    pub fn work(&self, core: Core) -> f64 {
        self.costs[core as usize] * f64::from(self.rate)
    }

    /// Work and median error in a scene of that size; infinite where it failed.
    pub fn point(&self, core: Core, size: f64) -> Point {
        let error = self.errors[1];
        let error = if error <= size { error } else { f64::INFINITY };
        (self.work(core), error)
    }

    /// Method, forces and body.
    pub fn line(&self) -> [&str; 3] {
        [&self.method, &self.forces, &self.body]
    }
}

/// The error that a part of all starts does not exceed, between two of them on the straight line; NaN
/// counts as infinite.
pub fn quantile(errors: &[f64], part: f64) -> f64 {
    let known = |error: &f64| {
        if error.is_nan() {
            f64::INFINITY
        } else {
            *error
        }
    };
    let mut sorted: Vec<f64> = errors.iter().map(known).collect();
    sorted.sort_by(f64::total_cmp);
    let at = part * (sorted.len() - 1) as f64;
    let (below, above) = (sorted[at.floor() as usize], sorted[at.ceil() as usize]);
    match below == above {
        true => below,
        false => below + at.fract() * (above - below),
    }
}
