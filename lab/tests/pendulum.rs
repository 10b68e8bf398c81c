//! The pendulum of the examples: its hinge to the bit, its period beside the elliptic integral and
//! beside what the method's modified energy says of it.
//!
//! Drift, kick, drift follows, but for the fourth power of h, the energy
//!
//! ```text
//! p²/2 + V + h² A,     A = V'²/12 - p² V''/24,     V = -cos θ in units of ω0
//! ```
//!
//! which of a spring gives the `(h ω)²/24` that the method states.

use fixstep_lab::support;

#[path = "../examples/pendulum/exact.rs"]
mod exact;
#[path = "../examples/pendulum/hinge.rs"]
mod hinge;
#[path = "pendulum/modified.rs"]
mod modified;
#[path = "../examples/pendulum/runs.rs"]
mod runs;
#[path = "../examples/pendulum/swing.rs"]
mod swing;
#[path = "../examples/pendulum/table.rs"]
mod table;

use std::f64::consts::{PI, TAU};
use std::sync::OnceLock;

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{
    Angle, DyadicStep, GravityY, Point, Rigid, Rotating, SemiImplicitEuler, Vec2, Verlet, World,
    vec2,
};

use hinge::Hinge;
use runs::{AMPLITUDES, Run};
use support::Format;
use swing::{ARM, AT_THE_PIN, FALL, INERTIA, MASS, SECONDS};

fn runs() -> &'static [Run] {
    static RUNS: OnceLock<Vec<Run>> = OnceLock::new();
    RUNS.get_or_init(|| runs::all().unwrap())
}

/// A pendulum of `degrees` in the example's measures.
fn hung<S: fixstep::Angular>(degrees: i32) -> (World<Rigid<Point<S>>, 1>, Hinge<S>) {
    let mut world = World::new();
    let rod = Rigid::new(Point::new(Vec2::ZERO, Vec2::ZERO, MASS).unwrap(), INERTIA).unwrap();
    let id = world.add(rod.with_angle(Angle::degrees(degrees))).unwrap();
    let hinge = Hinge::new(id, Vec2::ZERO, vec2(0, ARM).unwrap(), AT_THE_PIN).unwrap();
    hinge.hold(world.get_mut(id).unwrap());
    (world, hinge)
}

/// Sums of fixed point are exact: what is put on the pin is there, at rest.
#[test]
fn the_hole_never_leaves_the_pin() {
    fn check<S: fixstep::Angular>(what: &str) {
        let (mut world, hinge) = hung::<S>(100);
        let mut forces = (GravityY::new(FALL).unwrap(), hinge);
        let hole = vec2(0, ARM).unwrap();
        let step = DyadicStep::<S, 1, 6>::new().unwrap();
        for tick in 0..2000 {
            world.step(&mut Verlet, &mut forces, &step);
            let rod = world.bodies()[0];
            assert_eq!(rod.to_world(hole), Vec2::ZERO, "{what} tick {tick}");
            let slip = rod.velocity_off(rod.rotation().rotate(hole));
            assert_eq!(slip, Vec2::ZERO, "{what} tick {tick}");
        }
    }
    check::<I16F16>("I16F16");
    check::<I8F24>("I8F24");
}

/// The methods on `θ'' = -ω0² sin θ`, written down once more. 2000 steps of 1/64 s are 19 swings; a rounding of
/// 1e-16 in each grows with their square: 4e6 · 1e-16 · a few.
#[test]
fn in_f64_it_is_the_method_on_the_angle_alone() {
    let (h, w2) = (1.0 / 64.0, exact::frequency().powi(2));
    let kick = |angle: f64| -h * w2 * angle.sin();
    let step = DyadicStep::<f64, 1, 6>::new().unwrap();
    let ([mut verlet, mut semi], hinge) = ([hung(100).0, hung(100).0], hung(100).1);
    let mut forces = (GravityY::new(FALL).unwrap(), hinge);
    let [mut a, mut b] = [[100_f64.to_radians(), 0.0]; 2];
    for _ in 0..2000 {
        verlet.step(&mut Verlet, &mut forces, &step);
        semi.step(&mut SemiImplicitEuler, &mut forces, &step);
        a[0] += h / 2.0 * a[1];
        a[1] += kick(a[0]);
        a[0] += h / 2.0 * a[1];
        b[1] += kick(b[0]);
        b[0] += h * b[1];
    }
    for (what, world, [angle, omega]) in [("Verlet", verlet, a), ("semi-implicit", semi, b)] {
        let rod = world.bodies()[0];
        let errors = [rod.angle().to_f64() * TAU - angle, rod.spin() * TAU - omega];
        println!("{what:<14} {angle:+.6} rad {omega:+.6} rad/s  errors {errors:?}");
        assert!(
            errors.iter().all(|error| error.abs() <= 2e-9),
            "{what} {errors:?}"
        );
    }
}

/// `K(1/√2) = Γ(1/4)² / 4√π`, and the first terms of the series in `θ0`: the next is below `θ0^6 / 3000`.
/// Four roundings are allowed.
#[test]
fn the_exact_period_is_the_elliptic_integral() {
    let small = TAU / exact::frequency();
    assert!((exact::frequency().powi(2) / (1.5 * 9.81) - 1.0).abs() <= 4.0 * f64::EPSILON);
    const QUARTER: f64 = 3.625_609_908_221_908; // Γ(1/4)
    let lemniscate = QUARTER * QUARTER / (4.0 * PI.sqrt());
    let error = exact::period(90.0) / small / (lemniscate * 2.0 / PI) - 1.0;
    assert!(error.abs() <= 4.0 * f64::EPSILON, "{error:e}");
    let x = 10_f64.to_radians().powi(2);
    let series = 1.0 + x / 16.0 + 11.0 * x * x / 3072.0;
    let error = exact::period(10.0) / small / series - 1.0;
    assert!((0.0..=x.powi(3) / 3000.0).contains(&error), "{error:e}");
}

/// `f64` rounds by 1e-13 here. Left are the next power of `(h ω0)²` and the chord at a passage; both are
/// below its fourth.
#[test]
fn without_rounding_the_period_is_that_of_the_modified_energy() {
    for run in runs().iter().filter(|run| run.numbers == "f64") {
        let step = exact::frequency() / f64::from(run.rate);
        let wanted = step * step * modified::stretch(f64::from(run.degrees));
        let (error, bound) = ((run.error() - wanted).abs(), step.powi(4));
        println!(
            "{:3}° {} Hz: {:+.4e}, wanted {wanted:+.4e}, error {error:.1e}, bound {bound:.1e}",
            run.degrees,
            run.rate,
            run.error()
        );
        assert!(error <= bound, "{run:?}");
        // A mean over whole swings is off by a tick of the ripple.
        let ripple = step.powi(3) / 2.0;
        assert!(run.swing.drift.abs() <= ripple, "{run:?}");
    }
}

/// Roundings walk. Each step rounds the spin, and the moment that turns it: together by less than half a unit,
/// one sigma. Of ω after n steps, a step of σ at a random place of the swing, that leaves
///
/// ```text
/// energy      δE/E = 2 ω δω / ω_max², ω² is ω_max²/2 in the mean:     √(2 n) σ / ω_max
/// phase       √(n/2) σ / ω_max of a small swing, times two for a large one
/// period      that phase over 2π a swing, and d(ln T)/d(ln E) times a third of the energy's variance
/// ```
///
/// of which four sigma are allowed.
#[test]
fn rounding_moves_the_period_and_the_energy_as_a_walk_does() {
    for run in runs() {
        let unit = match run.numbers {
            "f64" => continue,
            "f32" => f32::unit(1.2),
            "I16F16" => I16F16::unit(0.0),
            "I8F24" => I8F24::unit(0.0),
            other => panic!("{other}?"),
        };
        let degrees = f64::from(run.degrees);
        let (steps, sigma) = (f64::from(SECONDS * run.rate), TAU * unit / 2.0);
        let fastest = 2.0 * exact::frequency() * (degrees.to_radians() / 2.0).sin();
        let energy = (2.0 * steps).sqrt() * sigma / fastest;
        let swings = f64::from(SECONDS) / exact::period(degrees);
        let phase = 2.0 * (steps / 2.0).sqrt() * sigma / fastest / (TAU * swings);
        let period = phase + modified::softening(degrees) * energy / 3_f64.sqrt();
        let error = (run.swing.period - run.smooth).abs() / run.smooth;
        println!(
            "{:3}° {:<6} period {error:.1e}, bound {:.1e}; energy {:+.1e}, bound {:.1e}",
            run.degrees,
            run.numbers,
            4.0 * period,
            run.swing.drift,
            4.0 * energy
        );
        assert!(error <= 4.0 * period, "{run:?}");
        assert!(run.swing.drift.abs() <= 4.0 * energy, "{run:?}");
    }
}

#[test]
fn the_table_has_a_row_for_each_run() {
    let rows = table::rows(runs());
    assert_eq!(rows.len(), 5 * AMPLITUDES.len());
    let columns = |row: &str| row.matches('|').count();
    assert!(rows.iter().all(|row| columns(row) == 9), "{rows:?}");
    assert!(table::HEAD.lines().all(|line| columns(line) == 9));
}
