//! The error of a run, and what it is made of.
//!
//! Four states at the same true time `t = n / rate`:
//!
//! ```text
//! E   exact solution,    coefficients as written
//! E'  exact solution,    coefficients as the scalar has them (module `represent`)
//! M   the method in f64, coefficients as written
//! M'  the method in f64, coefficients as the scalar has them
//! X   the method in the scalar
//!
//! error        |X - E|
//! method       |M - E|      of the step's length; the same for every scalar
//! coefficient  |E' - E|     of the scene; no method cures it
//! rounding     |X - M'|     of the state, step by step
//! ```
//!
//! `X - E = (X - M') + (M' - M) + (M - E)`, and `M' - M` is `E' - E` up to the product of a method
//! error and a coefficient error: the parts add up to that order. The coefficient error is taken
//! between exact solutions because there it stays meaningful where the method explodes. M is not
//! free of rounding, but `f64` leaves little: a cruise, which every method flies exactly, ends
//! 1e-9 m off after 1e6 steps.
//!
//! In the far scene both bodies fly in the scalar and the state is the difference of their
//! displacements: E is zero.

use fixstep::{Error, Scalar, Step, Vec2};

use crate::exact;
use crate::represent::Represented;
use crate::run::{Flight, Plan, Sample, fly};
use crate::scene::{Compare, Law, STARTS, Scene, Start};

/// Medians over the start values at one tick. A value that is no number is infinite.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    pub tick: u64,
    pub seconds: f64,
    pub error: f64,
    /// The largest error of any start.
    pub worst: f64,
    pub method: f64,
    pub coefficient: f64,
    pub rounding: f64,
    /// `|X - M|`: all that the scalar adds to the method's error.
    pub scalar: f64,
    pub energy: f64,
    pub momentum: f64,
}

/// What is compared, at each tick; `None` once out of range.
type Track = Vec<Option<Vec<Vec2<f64>>>>;

/// E and M of every start: what all scalars are measured against.
pub struct Reference {
    starts: Vec<(Track, Track)>,
}

impl Reference {
    pub fn new(scene: &Scene, plan: &Plan) -> Result<Self, Error> {
        let start = |index| {
            let bodies = scene.bodies(index, 0.0);
            let method = flown(plan, &bodies, fly::<f64>(plan, &bodies)?);
            Ok((solved(plan, scene.law, &bodies), method))
        };
        let starts = (0..STARTS).map(start).collect::<Result<_, Error>>()?;
        Ok(Reference { starts })
    }
}

/// One scalar against the reference. Refuses a scene that the scalar cannot hold.
pub fn compare<S: Scalar>(
    scene: &Scene,
    plan: &Plan,
    reference: &Reference,
) -> Result<Vec<Row>, Error> {
    let represented = Represented::<S>::new(Step::<S>::hz(plan.rate)?.seconds())?;
    let law = represented.law(scene.law, &scene.bodies(0, 0.0)[0])?;
    let start = |(index, of_start): (usize, &(Track, Track))| {
        let bodies = scene.bodies(index, 0.0);
        let bodies: Vec<Start> = bodies
            .iter()
            .map(|body| represented.body(body))
            .collect::<Result<_, _>>()?;
        let same_method = fly::<f64>(&Plan { law, ..*plan }, &bodies)?;
        let same = (
            solved(plan, law, &bodies),
            flown(plan, &bodies, same_method),
        );
        let flight = fly::<S>(plan, &scene.bodies(index, distance::<S>()))?;
        let invariants = flight.iter().map(invariants).collect();
        Ok(Run::new(
            plan.compare,
            of_start,
            &same,
            &flown(plan, &bodies, flight),
            invariants,
        ))
    };
    let runs = reference
        .starts
        .iter()
        .enumerate()
        .map(start)
        .collect::<Result<Vec<_>, Error>>()?;
    Ok(plan
        .ticks
        .iter()
        .enumerate()
        .map(|(i, &tick)| row(plan, &runs, i, tick))
        .collect())
}

/// The errors of one start, each at every tick.
struct Run {
    error: Vec<f64>,
    method: Vec<f64>,
    coefficient: Vec<f64>,
    rounding: Vec<f64>,
    scalar: Vec<f64>,
    /// Change of energy and of momentum.
    invariants: Vec<[f64; 2]>,
}

impl Run {
    /// From `(E, M)`, `(E', M')` and X.
    fn new(
        compare: Compare,
        (e, m): &(Track, Track),
        (e1, m1): &(Track, Track),
        x: &Track,
        invariants: Vec<[f64; 2]>,
    ) -> Self {
        let between = |a: &Track, b: &Track| {
            let pairs = a.iter().zip(b);
            pairs
                .map(|(a, b)| apart(compare, a.as_deref(), b.as_deref()))
                .collect()
        };
        Run {
            error: between(x, e),
            method: between(m, e),
            coefficient: between(e1, e),
            rounding: between(x, m1),
            scalar: between(x, m),
            invariants,
        }
    }
}

fn row(plan: &Plan, runs: &[Run], i: usize, tick: u64) -> Row {
    let over = |of: fn(&Run, usize) -> f64| sorted(runs.iter().map(|run| of(run, i)));
    let errors = over(|run, i| run.error[i]);
    Row {
        tick,
        seconds: tick as f64 / plan.rate.to_f64(),
        error: median(&errors),
        worst: errors[errors.len() - 1],
        method: median(&over(|run, i| run.method[i])),
        coefficient: median(&over(|run, i| run.coefficient[i])),
        rounding: median(&over(|run, i| run.rounding[i])),
        scalar: median(&over(|run, i| run.scalar[i])),
        energy: median(&over(|run, i| run.invariants[i][0])),
        momentum: median(&over(|run, i| run.invariants[i][1])),
    }
}

/// Rising; what is no number comes last, as infinity.
fn sorted(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values
        .map(|value| if value.is_nan() { f64::INFINITY } else { value })
        .collect();
    values.sort_by(f64::total_cmp);
    values
}

/// The upper of the two middle values.
fn median(sorted: &[f64]) -> f64 {
    sorted[sorted.len() / 2]
}

fn invariants(sample: &Option<Sample>) -> [f64; 2] {
    match sample {
        Some(sample) => [sample.energy, sample.momentum],
        None => [f64::INFINITY; 2],
    }
}

/// How far out the far scene is for a scalar: 0.9 of its range, 100 km for floats.
fn distance<S: Scalar>() -> f64 {
    let range = S::MAX.to_f64();
    if range < 1e12 { 0.9 * range } else { 1e5 }
}

fn flown(plan: &Plan, bodies: &[Start], flight: Flight) -> Track {
    let view = |displacements: &[_]| view(plan.compare, bodies, displacements);
    let samples = flight.into_iter();
    samples
        .map(|sample| sample.map(|sample| view(&sample.displacements)))
        .collect()
}

fn solved(plan: &Plan, law: Law, bodies: &[Start]) -> Track {
    let at = |&tick: &u64| {
        let t = tick as f64 / plan.rate.to_f64();
        let displacements = exact::displacements(law, bodies, t);
        Some(view(plan.compare, bodies, &displacements))
    };
    plan.ticks.iter().map(at).collect()
}

/// What the scene compares.
fn view(compare: Compare, bodies: &[Start], displacements: &[Vec2<f64>]) -> Vec<Vec2<f64>> {
    match (compare, displacements) {
        (Compare::SecondToFirst, [first, second]) => vec![*second - *first],
        _ => bodies
            .iter()
            .zip(displacements)
            .map(|(body, &moved)| body.position + moved)
            .collect(),
    }
}

/// The largest distance of a pair, m.
fn apart(compare: Compare, a: Option<&[Vec2<f64>]>, b: Option<&[Vec2<f64>]>) -> f64 {
    let (Some(a), Some(b)) = (a, b) else {
        return f64::INFINITY;
    };
    let between = |(&a, &b): (&Vec2<f64>, &Vec2<f64>)| {
        let mut apart = a - b;
        if let Compare::OnCircle(metres) = compare {
            let round = f64::from(metres);
            apart.x -= round * (apart.x / round).round();
        }
        apart.length()
    };
    // `max` would pass over a NaN.
    let larger = |x: f64, y: f64| if x >= y { x } else { y };
    a.iter().zip(b).map(between).fold(0.0, larger)
}
