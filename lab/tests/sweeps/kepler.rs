//! An orbit with e = 0.6 about a fixed centre, GM = 1 and a = 1, for ten turns of 2π s: how many force
//! calls it takes to end within 1 % of a from where Kepler's equation says.
//!
//! ```text
//! M = t,   E - e sin E = M
//! x = (cos E - e, 0.8 sin E)     v = (-sin E, 0.8 cos E) / (1 - e cos E)
//! ```
//!
//! Of sixteen bodies on the same orbit the worst counts, and every finer step that is tried must do
//! as well: a single body may pass by chance.

use crate::support;

use std::cell::Cell;
use std::f64::consts::TAU;

use fixstep::{PerBody, Point, Step, Time, Vec2, World};
use support::*;

const E: f64 = 0.6;
const TURNS: f64 = 10.0;

type Orbits = World<Point<f64>, 16>;

/// The eccentric anomaly by Newton's method; from π it converges for every e < 1.
fn eccentric(mean: f64) -> f64 {
    let mean = mean.rem_euclid(TAU);
    (0..60).fold(TAU / 2.0, |at, _| {
        at - (at - E * at.sin() - mean) / (1.0 - E * at.cos())
    })
}

/// The mean anomaly from which body `i` starts; the first is where it is fastest, with x = (0.4, 0) and
/// v = (0, 2).
fn phase(i: usize) -> f64 {
    TAU * i as f64 / 16.0
}

/// Position and velocity at mean anomaly `mean`.
fn exact(mean: f64) -> [[f64; 2]; 2] {
    let (sin, cos) = eccentric(mean).sin_cos();
    let rate = 1.0 / (1.0 - E * cos);
    [[cos - E, 0.8 * sin], [-sin * rate, 0.8 * cos * rate]]
}

fn start() -> Orbits {
    world(std::array::from_fn(|i| {
        let [x, v] = exact(phase(i));
        point(x, v, 1.0)
    }))
}

/// The inverse square, and nothing else.
fn attraction(body: &Point<f64>) -> Vec2<f64> {
    let x = body.position();
    let square = x.x * x.x + x.y * x.y;
    let factor = -1.0 / (square * square.sqrt());
    Vec2::new(x.x * factor, x.y * factor)
}

/// Energy of a body on the orbit: -1/2.
fn energy(body: &Point<f64>) -> f64 {
    let (x, v) = (body.position(), body.velocity());
    0.5 * (v.x * v.x + v.y * v.y) - 1.0 / x.x.hypot(x.y)
}

struct Outcome {
    /// Distance from the exact place, of a.
    errors: Vec<f64>,
    /// Change of energy, of itself.
    drifts: Vec<f64>,
    calls: u64,
}

/// Ten turns in `steps` steps.
fn run(scheme: Scheme, steps: u32) -> Outcome {
    let seconds = ratio(TURNS * TAU / f64::from(steps));
    let (mut world, mut method) = (start(), scheme.method());
    let (step, calls) = (Step::from_seconds(seconds).unwrap(), Cell::new(0));
    let mut force = PerBody(|_: Time, body: &Point<f64>| {
        calls.set(calls.get() + 1);
        attraction(body)
    });
    for _ in 0..steps {
        world.step(&mut method, &mut force, &step);
    }
    let error = |(i, body): (usize, &Point<f64>)| {
        let [x, _] = exact(phase(i) + f64::from(steps) * seconds.to_f64());
        let at = body.position();
        (at.x - x[0]).hypot(at.y - x[1])
    };
    let drift = |body: &Point<f64>| (energy(body) / -0.5 - 1.0).abs();
    Outcome {
        errors: world.bodies().iter().enumerate().map(error).collect(),
        drifts: world.bodies().iter().map(drift).collect(),
        calls: calls.get() / 16,
    }
}

/// Each rate is 2 % finer than the one before, up to `calls` force calls and a factor of two beyond.
fn rates(per_step: u32, calls: u32) -> Vec<u32> {
    let last = f64::from(2 * calls / per_step);
    let all = std::iter::successors(Some(260.0), |steps: &f64| Some(steps * 1.02));
    all.take_while(|&steps| steps <= last)
        .map(|steps| steps as u32)
        .collect()
}

/// Within `calls` calls and at every finer rate the error is below 1 %.
fn check(scheme: Scheme, per_step: u32, calls: u32) {
    let all = rates(per_step, calls);
    let worst = |&steps: &u32| maximum(&run(scheme, steps).errors);
    let good = |steps: &&u32| worst(steps) <= 0.01;
    let count = all.iter().rev().take_while(good).count();
    let steps = all[all.len() - count];
    let outcome = run(scheme, steps);
    println!(
        "{scheme:?}: 1 % from {} force calls, {:.0} steps a turn",
        outcome.calls,
        f64::from(steps) / TURNS
    );
    assert_eq!(outcome.calls, u64::from(steps * per_step));
    assert!(outcome.calls <= u64::from(calls));
    println!("  starting where it is fastest: {:.2e}", outcome.errors[0]);
    within(0.01, &format!("{scheme:?}, error"), &outcome.errors);
    println!(
        "  drift of energy: median {:.1e}, max {:.1e}",
        median(&outcome.drifts),
        maximum(&outcome.drifts)
    );
}

#[test]
fn verlet_needs_at_most_24000_calls() {
    check(Scheme::Verlet, 1, 24_000);
}

#[test]
fn rk4_needs_at_most_8000_calls() {
    check(Scheme::Rk4, 4, 8_000);
}

#[test]
fn pefrl_needs_at_most_4800_calls() {
    check(Scheme::Pefrl, 4, 4_800);
}

/// The largest error of energy, of itself, of each body in the first ten turns and in the last ten of a
/// hundred, at 200 steps a turn.
fn energies(scheme: Scheme) -> [[f64; 16]; 2] {
    const STEPS: u32 = 200;
    let (mut world, mut method) = (start(), scheme.method());
    let step = Step::from_seconds(ratio(TAU / f64::from(STEPS))).unwrap();
    let mut force = PerBody(|_: Time, body: &Point<f64>| attraction(body));
    let mut worst = [[0.0; 16]; 2];
    for tick in 0..100 * STEPS {
        world.step(&mut method, &mut force, &step);
        let span = match tick / STEPS {
            0..10 => 0,
            90.. => 1,
            _ => continue,
        };
        for (worst, body) in worst[span].iter_mut().zip(world.bodies()) {
            *worst = maximum(&[*worst, (energy(body) / -0.5 - 1.0).abs()]);
        }
    }
    worst
}

/// A symplectic method keeps an energy near the true one: the error of the last turns is that of the
/// first but for where steps meet the orbit, which the bodies' common motion moves by less than a tenth.
/// Runge-Kutta loses the same in every turn: ten times as much, more as the orbit shrinks.
#[test]
fn symplectic_methods_keep_energy_for_ever() {
    for scheme in [Scheme::Verlet, Scheme::Pefrl, Scheme::Rk4] {
        let [first, last] = energies(scheme);
        let growth: [f64; 16] = std::array::from_fn(|i| last[i] / first[i]);
        if scheme == Scheme::Rk4 {
            println!("{scheme:?}: error of energy grows {growth:.1?}");
            assert!(growth.iter().all(|&growth| growth >= 8.0));
        } else {
            within(1.1, &format!("{scheme:?}, growth of energy error"), &growth);
        }
    }
}
