//! A cell of the map of drag alone, by the kind of drag, and the limits of a kind: closed, and from a
//! measured step.

use fixstep::{ExactDrag, ExactQuadraticDrag, Force, LinearDrag, Point, QuadraticDrag, World};

use super::drag::{Course, Drag, speed};
use super::law::{Law, first_root};
use super::scene::*;
use crate::support::*;

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    Linear,
    LinearFactor,
    Quadratic,
    QuadraticFactor,
}

pub const KINDS: [Kind; 4] = [
    Kind::Linear,
    Kind::LinearFactor,
    Kind::Quadratic,
    Kind::QuadraticFactor,
];

pub const COLUMNS: usize = 32;

/// Rates up to here are searched for a limit.
const END: f64 = 6.0;

impl Kind {
    pub fn name(self) -> &'static str {
        match self {
            Kind::Linear => "linear force",
            Kind::LinearFactor => "linear factor",
            Kind::Quadratic => "quadratic force",
            Kind::QuadraticFactor => "quadratic factor",
        }
    }

    pub fn is_quadratic(self) -> bool {
        matches!(self, Kind::Quadratic | Kind::QuadraticFactor)
    }

    /// Rates of the map, evenly by their logarithm.
    pub fn column(self, i: usize) -> f64 {
        let span: f64 = if self.is_quadratic() { 1e5 } else { 1e4 };
        0.01 * span.powf(i as f64 / (COLUMNS - 1) as f64)
    }

    pub fn columns(self) -> impl Iterator<Item = f64> {
        (0..COLUMNS).map(move |i| self.column(i))
    }

    /// `v'/v` of a rate: of `k h / m`, or of `h c |v| / m`.
    pub fn factor(self, law: &Law, rate: f64) -> f64 {
        match self {
            Kind::Linear => (law.linear)(rate),
            Kind::LinearFactor => (-rate).exp(),
            Kind::Quadratic => (law.quadratic)(rate),
            Kind::QuadraticFactor => 1.0 / (1.0 + rate),
        }
    }

    /// Where `|v'| <= |v|` first ends, by the closed form; infinite where it does not.
    pub fn limit(self, law: &Law) -> f64 {
        first_root(|rate| self.factor(law, rate).abs() <= 1.0, END)
    }

    /// The same from a step in `f64` of a speed of 1 m/s, whose four calls at most round terms below
    /// 1000.
    pub fn measured_limit(self, law: &Law) -> f64 {
        let slack = 4.0 * 1000.0 * f64::EPSILON;
        first_root(|rate| self.step(law, rate).abs() <= 1.0 + slack, END)
    }

    /// What a step makes of 1 m/s.
    fn step(self, law: &Law, rate: f64) -> f64 {
        let mut world: World<Point<f64>, 1> = world([point([0.0; 2], [1.0, 0.0], 1.0)]);
        let mut method = law.scheme.method();
        let k = ratio(rate * RATE);
        match self {
            Kind::Linear => world.step(&mut method, &mut LinearDrag::new(k).unwrap(), &step()),
            Kind::LinearFactor => world.step(&mut method, &mut ExactDrag::new(k).unwrap(), &step()),
            Kind::Quadratic => {
                world.step(&mut method, &mut QuadraticDrag::new(k).unwrap(), &step());
            }
            Kind::QuadraticFactor => {
                let mut drag = ExactQuadraticDrag::new(k).unwrap();
                world.step(&mut method, &mut drag, &step());
            }
        }
        state(&world.bodies()[0]).1[0]
    }

    /// What becomes of sixteen speeds, each step held to the closed form.
    pub fn course<S: Number>(self, law: &Law, rate: f64) -> Course {
        let speed = speed::<S>();
        let (k, c) = (ratio(rate * RATE), ratio(rate * RATE / speed));
        match self {
            Kind::Linear => self.check::<S>(law, rate, LinearDrag::new(k).unwrap()),
            Kind::LinearFactor => self.check::<S>(law, rate, ExactDrag::new(k).unwrap()),
            Kind::Quadratic => self.check::<S>(law, rate, QuadraticDrag::new(c).unwrap()),
            Kind::QuadraticFactor => {
                self.check::<S>(law, rate, ExactQuadraticDrag::new(c).unwrap())
            }
        }
    }

    fn check<S: Number>(self, law: &Law, rate: f64, mut force: impl Force<Point<S>>) -> Course {
        let speed = speed::<S>();
        let exact = matches!(self, Kind::LinearFactor | Kind::QuadraticFactor);
        let drag = Drag {
            name: self.name().into(),
            factor: &|v| match self.is_quadratic() {
                true => self.factor(law, rate * v / speed),
                false => self.factor(law, rate),
            },
            rate,
            calls: if exact { 1 } else { law.calls },
        };
        drag.check::<S>(law.scheme, &mut force)
    }
}

/// A row of the map: `.` monotone, `~` swinging, `#` exploding, `?` clamped.
pub fn row(courses: impl Iterator<Item = Course>) -> String {
    let sign = |course| match course {
        Course::Monotone => '.',
        Course::Swinging => '~',
        Course::Exploding => '#',
        Course::Clamped => '?',
    };
    courses.map(sign).collect()
}
