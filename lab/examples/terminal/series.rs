//! Everything that is measured: each scalar and method over all falls.

use fixstep::fixed::types::{I8F24, I12F20, I16F16};

use crate::bound::{Bound, bound};
use crate::fall::{Outcome, outcome};
use crate::scene::{FALLS, Fall, Law, SPEEDS};
use crate::support::{Format, SCHEMES, Scheme, maximum, median};

/// One scalar and method.
pub struct Series {
    pub scalar: String,
    pub scheme: Scheme,
    /// A cell for each of [`SPEEDS`], for each law.
    pub laws: [Vec<Cell>; 2],
}

/// All falls with one law and one terminal speed.
pub struct Cell {
    speed: f64,
    pub outcomes: Vec<Outcome>,
    pub bounds: Vec<Bound>,
}

impl Series {
    /// Every outcome of a law, with its bound.
    pub fn all(&self, law: Law) -> impl Iterator<Item = (&Outcome, &Bound)> {
        let cells = self.laws[law as usize].iter();
        cells.flat_map(|cell| cell.outcomes.iter().zip(&cell.bounds))
    }

    /// Median and largest of the worst ticks of a law.
    pub fn worst(&self, law: Law) -> [f64; 2] {
        let errors: Vec<f64> = self.all(law).map(|(outcome, _)| outcome.worst).collect();
        [median(&errors), maximum(&errors)]
    }

    /// Whether all velocities are the same in every bit.
    fn same(&self, other: &Series) -> bool {
        let same = |law| {
            let [a, b] = [self, other].map(|series| series.all(law));
            a.map(|(outcome, _)| outcome)
                .eq(b.map(|(outcome, _)| outcome))
        };
        self.scalar == other.scalar && Law::BOTH.into_iter().all(same)
    }
}

impl Cell {
    /// m/s
    pub fn speed(&self) -> f64 {
        self.speed
    }

    /// The median of the mean velocities' errors.
    pub fn mean(&self) -> f64 {
        median(&self.outcomes.iter().map(|o| o.mean).collect::<Vec<_>>())
    }

    /// The median of the worst ticks.
    pub fn error(&self) -> f64 {
        median(&self.outcomes.iter().map(|o| o.worst).collect::<Vec<_>>())
    }

    /// The largest of the worst ticks.
    pub fn largest(&self) -> f64 {
        maximum(&self.outcomes.iter().map(|o| o.worst).collect::<Vec<_>>())
    }

    /// The median of the bounds, which bounds the median of the worst ticks.
    pub fn bound(&self) -> f64 {
        median(&self.bounds.iter().map(|b| b.worst).collect::<Vec<_>>())
    }

    /// The same for the mean velocities.
    pub fn mean_bound(&self) -> f64 {
        median(&self.bounds.iter().map(|b| b.mean).collect::<Vec<_>>())
    }
}

/// All scalars and methods.
pub fn measure() -> Vec<Series> {
    let mut all = Vec::new();
    all.extend(SCHEMES.map(series::<f64>));
    all.extend(SCHEMES.map(series::<f32>));
    all.extend(SCHEMES.map(series::<I16F16>));
    all.extend(SCHEMES.map(series::<I12F20>));
    all.extend(SCHEMES.map(series::<I8F24>));
    all
}

/// From rest, over all speeds; no two falls have the same gravity.
fn series<S: Format>(scheme: Scheme) -> Series {
    let cell = |law, row: usize| {
        let fall = |i| Fall::spread(law, SPEEDS[row], row * FALLS + i);
        let falls: Vec<Fall> = (0..FALLS).map(fall).collect();
        let outcome = |fall| outcome::<S>(scheme, fall, 0.0);
        Cell {
            speed: SPEEDS[row],
            outcomes: falls.iter().map(outcome).collect(),
            bounds: falls.iter().map(bound::<S>).collect(),
        }
    };
    let cells = |law| (0..SPEEDS.len()).map(|row| cell(law, row)).collect();
    Series {
        scalar: S::name(),
        scheme,
        laws: Law::BOTH.map(cells),
    }
}

/// Methods that made the same bits with one scalar.
pub struct Group<'a> {
    pub schemes: Vec<Scheme>,
    /// The series of any of them.
    pub series: &'a Series,
}

impl Group<'_> {
    /// Whether all methods are in it.
    pub fn is_of_all(&self) -> bool {
        self.schemes.len() == SCHEMES.len()
    }

    /// Those of the medians with a law.
    pub fn bounds(&self, law: Law) -> impl Iterator<Item = f64> {
        self.series.laws[law as usize].iter().map(Cell::bound)
    }

    /// As tables and legends have it.
    pub fn label(&self) -> String {
        if self.is_of_all() {
            return "all four".to_string();
        }
        let names: Vec<String> = self.schemes.iter().map(|s| format!("{s:?}")).collect();
        names.join(", ")
    }
}

/// All series, those in one group that agree in every bit.
pub fn coinciding(all: &[Series]) -> Vec<Group<'_>> {
    let mut groups: Vec<Group> = Vec::new();
    for series in all {
        let same = |group: &&mut Group| group.series.same(series);
        match groups.iter_mut().find(same) {
            Some(group) => group.schemes.push(series.scheme),
            None => groups.push(Group {
                schemes: vec![series.scheme],
                series,
            }),
        }
    }
    groups
}
