//! The search: every rate with every setting, and what stands out.

use crate::count;
use crate::engine::{self, Engine, Setting};
use crate::problem::{ALL, Kind};

/// Hz; every run lasts a whole number of steps at each. The first is the default.
pub const RATES: [u32; 5] = [60, 120, 240, 480, 960];

/// One engine on one problem at one rate with one setting.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    pub problem: String,
    pub engine: String,
    pub rate: u32,
    pub setting: String,
    /// Whether setting and rate are the default.
    pub default: bool,
    /// Over the starts, m.
    pub median: f64,
    pub max: f64,
    /// Per body and step.
    pub instructions: Option<f64>,
}

impl Row {
    /// Instructions per body and simulated second.
    pub fn cost(&self) -> Option<f64> {
        Some(self.instructions? * f64::from(self.rate))
    }

    /// NaN and infinity are as bad as can be.
    fn error(&self) -> f64 {
        if self.median.is_finite() {
            self.median
        } else {
            f64::INFINITY
        }
    }
}

/// All rows, by problem, engine, setting and rate.
pub fn run() -> Vec<Row> {
    let counts = count::all();
    let engines = engine::all();
    let (mut rows, mut job) = (Vec::new(), 0);
    for kind in ALL {
        for engine in &engines {
            for (i, setting) in engine.settings(kind).iter().enumerate() {
                let instructions = counts.as_ref().and_then(|counts| counts.get(job).copied());
                job += 1;
                for rate in RATES {
                    let [median, max] = errors(&**engine, kind, setting, rate);
                    rows.push(Row {
                        problem: kind.name().into(),
                        engine: engine.name().into(),
                        rate,
                        setting: setting.label.into(),
                        default: i == 0 && rate == RATES[0],
                        median,
                        max,
                        instructions,
                    });
                }
            }
        }
    }
    rows
}

/// Median and maximum over the starts of the distance from the exact state at the end.
fn errors(engine: &dyn Engine, kind: Kind, setting: &Setting, rate: u32) -> [f64; 2] {
    let mut scene = engine.build(kind, setting, rate);
    scene.advance(rate * kind.seconds());
    let end = f64::from(kind.seconds());
    let starts = kind.starts();
    let distances = scene
        .states()
        .iter()
        .zip(&starts)
        .map(|(state, start)| kind.distance(state, &kind.exact(start, end)))
        .collect();
    summary(distances)
}

fn summary(mut errors: Vec<f64>) -> [f64; 2] {
    errors.sort_by(f64::total_cmp); // NaN behind infinity
    let middle = errors.len() / 2;
    [
        (errors[middle - 1] + errors[middle]) / 2.0,
        errors[errors.len() - 1],
    ]
}

/// What stands out of the rows of one engine and problem: the default; the least median error at no more
/// than its cost; the least of all. Of equal errors the cheaper one. The second needs counts.
pub fn chosen<'a>(rows: &[&'a Row]) -> [Option<&'a Row>; 3] {
    let best = |within: f64| {
        let key = |row: &Row| (row.error(), row.cost().unwrap_or(row.rate.into()));
        rows.iter()
            .copied()
            .filter(|row| within.is_infinite() || row.cost().is_some_and(|cost| cost <= within))
            .min_by(|a, b| key(a).partial_cmp(&key(b)).expect("no error is NaN"))
    };
    let default = rows.iter().copied().find(|row| row.default);
    let cost = default.and_then(Row::cost);
    [default, cost.and_then(best), best(f64::INFINITY)]
}

#[cfg(test)]
pub mod tests {
    use super::*;

    pub fn row(rate: u32, median: f64, instructions: Option<f64>) -> Row {
        Row {
            problem: "p".into(),
            engine: "e".into(),
            rate,
            setting: "s".into(),
            default: rate == 60,
            median,
            max: median,
            instructions,
        }
    }

    #[test]
    fn the_middle_of_an_even_number_lies_between_two() {
        assert_eq!(summary(vec![4.0, 1.0, 3.0, 2.0]), [2.5, 4.0]);
        let [median, max] = summary(vec![1.0, f64::NAN, 2.0, 3.0]);
        assert!(median == 2.5 && max.is_nan());
    }

    #[test]
    fn the_best_is_chosen_with_and_without_a_limit() {
        let rows = [
            row(60, 3.0, Some(100.0)), // 6000 a second
            row(120, 2.0, Some(50.0)), // 6000 too
            row(240, 1.0, Some(50.0)),
            row(480, f64::NAN, Some(1.0)),
        ];
        let all: Vec<&Row> = rows.iter().collect();
        let [default, equal, best] = chosen(&all).map(|row| row.expect("counts are there").rate);
        assert_eq!([default, equal, best], [60, 120, 240]);
    }

    #[test]
    fn without_counts_there_is_no_equal_cost() {
        let rows = [row(60, 3.0, None), row(120, 3.0, None)];
        let all: Vec<&Row> = rows.iter().collect();
        let [default, equal, best] = chosen(&all).map(|row| row.map(|row| row.rate));
        assert_eq!([default, equal, best], [Some(60), None, Some(60)]);
    }
}
