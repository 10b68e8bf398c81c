//! The map of drag alone: linear and quadratic, as a force and as a factor, and both sides of each limit.

use fixstep::{ExactDrag, ExactQuadraticDrag, LinearDrag, QuadraticDrag};

use crate::drag::{Course, Drag, speed};
use crate::law::{LAWS, Law, first_root};
use crate::scene::*;
use crate::support::*;

/// Of the grid: `from` to `to`, evenly by their logarithm.
const COLUMNS: usize = 32;

fn grid(from: f64, to: f64) -> impl Iterator<Item = f64> {
    (0..COLUMNS).map(move |i| from * (to / from).powf(i as f64 / (COLUMNS - 1) as f64))
}

/// A row for print: `.` monotone, `~` swinging, `#` exploding, `?` clamped.
fn row(courses: impl Iterator<Item = Course>) -> String {
    let sign = |course| match course {
        Course::Monotone => '.',
        Course::Swinging => '~',
        Course::Exploding => '#',
        Course::Clamped => '?',
    };
    courses.map(sign).collect()
}

/// All of one law: the grid, and a five-hundredth on both sides of where it explodes.
fn check_law<S: Number>(law: &Law) {
    let mass = |rate: f64| ratio(rate * RATE);
    let speed = speed::<S>();
    let linear = |rate: f64| {
        let drag = Drag {
            name: "linear".into(),
            factor: &|_| (law.linear)(rate),
            rate,
            calls: law.calls,
        };
        drag.check::<S>(law.scheme, &mut LinearDrag::new(mass(rate)).unwrap())
    };
    let quadratic = |rate: f64| {
        let factor = |v: f64| (law.quadratic)(rate * v / speed);
        let drag = Drag {
            name: "quadratic".into(),
            factor: &factor,
            rate,
            calls: law.calls,
        };
        drag.check::<S>(
            law.scheme,
            &mut QuadraticDrag::new(mass(rate / speed)).unwrap(),
        )
    };
    let exact_linear = |rate: f64| {
        let drag = Drag {
            name: "exact linear".into(),
            factor: &|_| (-rate).exp(),
            rate,
            calls: 1,
        };
        drag.check::<S>(law.scheme, &mut ExactDrag::new(mass(rate)).unwrap())
    };
    let exact_quadratic = |rate: f64| {
        let factor = |v: f64| 1.0 / (1.0 + rate * v / speed);
        let drag = Drag {
            name: "exact quadratic".into(),
            factor: &factor,
            rate,
            calls: 1,
        };
        drag.check::<S>(
            law.scheme,
            &mut ExactQuadraticDrag::new(mass(rate / speed)).unwrap(),
        )
    };
    let holds = |f: fn(f64) -> f64| first_root(move |rate| f(rate).abs() <= 1.0, 6.0);
    let limits = [holds(law.linear), holds(law.quadratic)];
    let what = format!("{:<8}{:?}", S::name(), law.scheme);
    println!(
        "{what:<32}linear, force       {:<34}limit {:.4}",
        row(grid(0.01, 100.0).map(linear)),
        limits[0]
    );
    println!(
        "{what:<32}linear, factor      {}",
        row(grid(0.01, 100.0).map(exact_linear))
    );
    println!(
        "{what:<32}quadratic, force    {:<34}limit {:.4}",
        row(grid(0.01, 1000.0).map(quadratic)),
        limits[1]
    );
    println!(
        "{what:<32}quadratic, factor   {}",
        row(grid(0.01, 1000.0).map(exact_quadratic))
    );
    for side in [0.998, 1.002] {
        linear(side * limits[0]);
        quadratic(side * limits[1]);
    }
}

pub fn check<S: Number>() {
    LAWS.iter().for_each(check_law::<S>);
}
