//! Eight bodies that draw each other, 100,000 steps: momentum and energy change by the rounding of
//! velocities and positions alone. Beside it: the law itself, and bodies that come too close.

#[path = "nbody/close.rs"]
mod close;
#[path = "nbody/law.rs"]
mod law;
#[path = "nbody/masses.rs"]
mod masses;
#[path = "nbody/scene.rs"]
mod scene;
use crate::support;

use fixstep::fixed::types::{I8F24, I12F20, I16F16, I20F12};
use fixstep::{Step, World};
use scene::*;
use support::*;

const STEPS: u32 = long(100_000) as u32;

/// Kicks of one body in a step.
const KICKS: f64 = (N - 1) as f64;

/// The largest relative error of a coefficient of the pull. Fixed point, in parts of 2^-31: G h three
/// (which is `COEFFICIENT`), the inverse of s two, cubed six, four products, a mass two: 15. Floats, in
/// epsilons: G h 1.5, the inverse 1.75 and one for the differences of positions, cubed 8.25, four
/// products two, a mass half: 12.25.
fn pull_error<S: Format>() -> f64 {
    8.2 * S::COEFFICIENT
}

/// What is read off the state every now and then.
#[derive(Clone, Copy, Default)]
struct Reading {
    kinetic: f64,
    potential: f64,
    /// `sum(v·F)`
    power: f64,
    /// `sum(F²/m)`
    strain: f64,
    /// The sum over pairs of `u·U″u`.
    bend: f64,
    /// `sum(m² v²)`
    momenta: f64,
    /// `sum(F²)`
    forces: f64,
    /// The sum over pairs of `(|f| |u|)²`, and of `f²`.
    pair_power: f64,
    pair_force: f64,
}

fn read(law: Law, stars: &[Star]) -> Reading {
    let mut reading = Reading::default();
    for (star, force) in stars.iter().zip(law.forces(stars)) {
        let (square, push) = (dot(star.v, star.v), dot(force, force));
        reading.kinetic += 0.5 * star.m * square;
        reading.momenta += star.m * star.m * square;
        reading.power += dot(star.v, force);
        reading.strain += push / star.m;
        reading.forces += push;
    }
    for (i, j) in pairs(stars.len()) {
        let (a, b) = (&stars[i], &stars[j]);
        let (force, u) = (law.force(a, b), minus(b.v, a.v));
        reading.potential += law.potential(a, b);
        reading.bend += law.bend(a, b);
        reading.pair_force += dot(force, force);
        reading.pair_power += dot(force, force) * dot(u, u);
    }
    reading
}

impl Reading {
    /// The energy that the method keeps up to one more power of h ω, from the series of commutators
    /// of kick and drift; of a spring it agrees with what each method keeps, to that power:
    ///
    /// ```text
    /// kick, drift          T + U + h/2 sum(v·F) + h²/12 (sum(F²/m) + u·U″u)
    /// drift, kick, drift   T + U + h² (sum(F²/m) / 12 - u·U″u / 24)
    /// ```
    fn kept(&self, scheme: Scheme) -> f64 {
        let first = match scheme {
            Scheme::SemiImplicitEuler => 0.5 / RATE * self.power,
            _ => 0.0,
        };
        self.kinetic + self.potential + first + self.second(scheme)
    }

    /// Its part with h².
    fn second(&self, scheme: Scheme) -> f64 {
        let sum = match scheme {
            Scheme::SemiImplicitEuler => (self.strain + self.bend) / 12.0,
            _ => self.strain / 12.0 - self.bend / 24.0,
        };
        sum / (RATE * RATE)
    }
}

/// Largest less smallest.
fn swing(readings: &[Reading], of: impl Fn(&Reading) -> f64) -> f64 {
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for value in readings.iter().map(of) {
        (low, high) = (low.min(value), high.max(value));
    }
    high - low
}

fn mean(readings: &[Reading], of: impl Fn(&Reading) -> f64) -> f64 {
    readings.iter().map(of).sum::<f64>() / readings.len() as f64
}

/// What a run leaves: all readings, and for each body its mass, and its units of velocity and
/// position at the largest it had.
struct Run {
    readings: Vec<Reading>,
    momentum: f64,
    units: [[f64; 3]; N],
    speeds: [f64; N],
}

fn run<S: Scale>(scheme: Scheme, i: usize) -> Run {
    let (mut world, law): (World<_, N>, _) = (cluster::<S>(i), law::<S>());
    let (mut method, mut pull) = (scheme.method(), law.pull::<S>());
    let step = Step::hz(ratio(RATE)).unwrap();
    let (start, mut momentum) = (world.momentum(), 0.0_f64);
    let mut readings = vec![read(law, &stars(&world))];
    let (mut places, mut speeds) = ([0.0_f64; N], [0.0_f64; N]);
    for tick in 1..=STEPS {
        world.step(&mut method, &mut pull, &step);
        if !tick.is_multiple_of(32) {
            continue;
        }
        let (stars, change) = (stars(&world), world.momentum() - start);
        momentum = maximum(&[momentum, change.x.abs(), change.y.abs()]);
        for (k, star) in stars.iter().enumerate() {
            places[k] = maximum(&[places[k], star.x[0].abs(), star.x[1].abs()]);
            speeds[k] = maximum(&[speeds[k], star.v[0].abs(), star.v[1].abs()]);
        }
        readings.push(read(law, &stars));
    }
    assert_eq!(world.out_of_range().count(), 0, "{}", S::name());
    let masses: Vec<f64> = stars(&world).iter().map(|star| star.m).collect();
    let units = std::array::from_fn(|k| [masses[k], S::unit(speeds[k]), S::unit(places[k])]);
    Run {
        readings,
        momentum,
        units,
        speeds,
    }
}

/// Each kick rounds a velocity, which changes the momentum along an axis by m times an error of
/// variance 1/12 of a unit²; and the two coefficients of a pair are not quite one over the other.
/// Their products round anew in every step: N errors of h f. Their masses are off for ever, body i's
/// by δ: over all pairs that leaves `-sum(δ F)`, over time `-sum(δ m Δv)`. Five standard deviations.
fn momentum_bound<S: Scale>(run: &Run) -> f64 {
    let kicks: f64 = run.units.iter().map(|[m, v, _]| (m * v).powi(2)).sum();
    let pairs = mean(&run.readings, |r| r.pair_force) * (pull_error::<S>() / RATE).powi(2);
    let variance = f64::from(STEPS) * (KICKS * kicks / 12.0 + pairs);
    let speeds = run.units.iter().zip(run.speeds);
    let moved: f64 = speeds.map(|([m, ..], speed)| m * 2.0 * speed).sum();
    5.0 * variance.sqrt() + pull_error::<S>() * moved
}

/// An error δ of a velocity changes the energy by `m v·δ + m δ²/2`, one of a position by `-F·δ`, one
/// of a coefficient by a part of `h f·u`: walks, but for the squares, whose mean is `m/24` of a unit²
/// an axis, and for what is wrong for ever, which is another G or h. The two half drifts between
/// two kicks of Verlet multiply the same velocity and round alike: twice the error, not twice the
/// variance. What the method does not keep is smaller than the last term kept by h ω, of Verlet,
/// which has only even powers, by its square.
fn energy_bound<S: Scale>(scheme: Scheme, run: &Run) -> f64 {
    let (all, units, n) = (&run.readings, &run.units, f64::from(STEPS));
    let largest = |k: usize| units.iter().map(|unit| unit[k]).fold(0.0, f64::max);
    let alike = scheme.drifts() * scheme.drifts();
    let kicks = KICKS * largest(1).powi(2) / 12.0 * mean(all, |r| r.momenta);
    let drifts = alike * largest(2).powi(2) / 12.0 * mean(all, |r| r.forces);
    let pulls = (pull_error::<S>() / RATE).powi(2) * mean(all, |r| r.pair_power);
    let walk = 5.0 * (n * (kicks + drifts + pulls)).sqrt();
    let squares: f64 = units.iter().map(|[m, v, _]| m * v * v).sum();
    let constant = swing(all, |r| r.kinetic) + swing(all, |r| r.potential);
    let part = FASTEST / RATE;
    let method = swing(all, |r| r.second(scheme))
        * match scheme {
            Scheme::SemiImplicitEuler => part,
            _ => part * part,
        };
    walk + n * KICKS * squares / 12.0 + pull_error::<S>() * constant + method
}

/// Errors as parts of the bound of each run, none of them NaN.
fn hold(what: &str, parts: &[f64]) {
    let (median, max) = (median(parts), maximum(parts));
    println!("{what:<40} median {median:.2}  max {max:.2} of the bound");
    assert!(parts.iter().all(|&part| part <= 1.0), "{what}: {max}");
}

/// Both methods by turns.
fn check<S: Scale>() {
    let (mut momenta, mut energies, mut relative) = (vec![], vec![], vec![]);
    for i in 0..S::STARTS {
        let scheme = [Scheme::Verlet, Scheme::SemiImplicitEuler][i % 2];
        let run = run::<S>(scheme, i);
        let start = run.readings[0].kept(scheme);
        let error = |reading: &Reading| (reading.kept(scheme) - start).abs();
        let errors: Vec<f64> = run.readings.iter().map(error).collect();
        assert!(start < 0.0, "{}: not bound", S::name());
        momenta.push(run.momentum / momentum_bound::<S>(&run));
        energies.push(maximum(&errors) / energy_bound::<S>(scheme, &run));
        relative.push(maximum(&errors) / -start);
        // A bound made of what was seen must still bound: a thousandth of the energy.
        let bound = energy_bound::<S>(scheme, &run) / -start;
        assert!(bound <= 1e-3, "{}: {bound}", S::name());
    }
    hold(&format!("{} momentum of eight", S::name()), &momenta);
    hold(&format!("{} energy of eight", S::name()), &energies);
    let (median, max) = (median(&relative), maximum(&relative));
    println!(
        "{} energy, of itself: median {median:.1e}  max {max:.1e}",
        S::name()
    );
}

#[test]
fn eight_bodies_keep_momentum_and_energy_in_f32() {
    check::<f32>();
}

#[test]
fn eight_bodies_keep_momentum_and_energy_in_f64() {
    check::<f64>();
}

#[test]
fn eight_bodies_keep_momentum_and_energy_in_i16f16() {
    check::<I16F16>();
}

#[test]
fn eight_bodies_keep_momentum_and_energy_in_i12f20() {
    check::<I12F20>();
}

#[test]
fn eight_bodies_keep_momentum_and_energy_in_i8f24() {
    check::<I8F24>();
}

#[test]
fn eight_bodies_keep_momentum_and_energy_in_i20f12() {
    check::<I20F12>();
}
