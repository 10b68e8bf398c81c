//! What a chart is made of: rows of text, kept as CSV beside the pictures. Charts are drawn from such a
//! table alone, and a fresh one is compared with the committed one.

use std::collections::{HashMap, HashSet};

/// How much of a chart is made. The rows of `Quick` are a subset of those of `Full`, and the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    Quick,
    Full,
}

/// Rows as text; the first `keys` columns name a row. No cell has a comma or a line break in it.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    pub name: &'static str,
    pub keys: usize,
    pub header: Vec<&'static str>,
    pub rows: Vec<Vec<String>>,
}

/// By how much a figure may differ, absolutely: far below what any chart shows, far above what a
/// sine of the host that differs in its last bit changes in an error: 2e-16 of some ten metres.
const FLOOR: f64 = 1e-12;

impl Table {
    /// The text of a CSV file.
    pub fn csv(&self) -> String {
        let header = [self.header.join(",")];
        let rows = self.rows.iter().map(|row| row.join(","));
        let lines = header.into_iter().chain(rows);
        lines.map(|line| line + "\n").collect()
    }

    /// The rows of a CSV file that has the same columns as this table.
    pub fn read(&self, text: &str) -> Result<Vec<Vec<String>>, String> {
        let name = self.name;
        let mut lines = text.lines();
        if lines.next() != Some(&self.header.join(",")) {
            return Err(format!("{name}.csv has other columns"));
        }
        let cells = |line: &str| line.split(',').map(String::from).collect::<Vec<_>>();
        let rows: Vec<_> = lines.map(cells).collect();
        match rows.iter().find(|row| row.len() != self.header.len()) {
            Some(row) => Err(format!("{name}.csv has a torn row: {}", row.join(","))),
            None => Ok(rows),
        }
    }

    /// What is different in the committed rows, a line each; nothing where they say the same. All of
    /// them must have been made where `effort` is full.
    pub fn differences(&self, committed: &[Vec<String>], effort: Effort) -> Vec<String> {
        let place = |row: &[String]| format!("{}, row {}", self.name, self.key(row).join(" "));
        let old: HashMap<&[String], &Vec<String>> =
            committed.iter().map(|row| (self.key(row), row)).collect();
        let mut found = Vec::new();
        for row in &self.rows {
            let Some(was) = old.get(self.key(row)) else {
                found.push(format!("{}: not in the committed file", place(row)));
                continue;
            };
            for ((name, is), was) in self.header.iter().zip(row).zip(*was) {
                if !same(is, was) {
                    found.push(format!("{}: {name} is {is}, committed {was}", place(row)));
                }
            }
        }
        let made: HashSet<&[String]> = self.rows.iter().map(|row| self.key(row)).collect();
        if effort == Effort::Full {
            let gone = committed.iter().filter(|row| !made.contains(self.key(row)));
            found.extend(gone.map(|row| format!("{}: is made no more", place(row))));
        }
        found
    }

    fn key<'a>(&self, row: &'a [String]) -> &'a [String] {
        &row[..self.keys.min(row.len())]
    }
}

/// Whether two cells agree: as text, or as figures within one unit of the last digit that is shown. A
/// last bit of the host's `sin` or `exp` may turn that digit, and no other.
fn same(is: &str, was: &str) -> bool {
    if is == was {
        return true;
    }
    let (Ok(a), Ok(b)) = (is.parse::<f64>(), was.parse::<f64>()) else {
        return false;
    };
    (a - b).abs() <= last_digit(is).max(last_digit(was)) * 1.001 + FLOOR
}

/// What a unit of the last digit of a decimal is worth: `0.001` of `2.500`, `1e-8` of `-3.50e-6`.
fn last_digit(text: &str) -> f64 {
    let (digits, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let behind = digits.split_once('.').map_or(0, |(_, behind)| behind.len());
    10_f64.powi(exponent.parse::<i32>().unwrap_or(0) - behind as i32)
}
