//! Two bodies on a spring between points off their centres, alone: what rounding makes of their momenta.
//!
//! ```text
//! P = sum m v        L = sum m x × v + I ω        about the origin
//! ```
//!
//! The impulse of a step is taken from one body as it is given to the other, at the same arms as the line has that
//! it acts along, so that in exact arithmetic no step changes P or L. Roundings do, each by itself
//! (`angular_momentum/noise.rs`): both walk, by the root of N steps.
//!
//! `angular_momentum/rewind.rs` leads such scenes back, to the bit.

#[path = "angular_momentum/noise.rs"]
mod noise;
#[path = "angular_momentum/rewind.rs"]
mod rewind;
use crate::support;

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::rigid::Centre;
use fixstep::rigid::torque::Attached;
use fixstep::{
    Angle, Carried, Force, Pairs, Point, Rigid, Rotating, Spring, Step, Vec2, Verlet, World,
};
use noise::{Kind, Sizes};
use support::*;

/// Half decades of steps.
const COUNTS: [u32; 7] = [100, 316, 1000, 3162, 10_000, 31_623, 100_000];

const STARTS: usize = 24;

const MASSES: [f64; 2] = [1.37, 2.91];

const INERTIAS: [f64; 2] = [0.41, 0.73];

const RATE: f64 = 60.0;

const STIFFNESS: f64 = 30.0;

/// Pair `i`, at its own angle, angles and spins: 3 m apart, turning about each other, and drifting.
fn pair<C: Centre + From<Point<C::S>> + std::fmt::Debug>(i: usize) -> World<Rigid<C>, 2> {
    let (sin, cos) = angle(i).sin_cos();
    let total = MASSES[0] + MASSES[1];
    let body = |k: usize, along: f64, across: f64| {
        let velocity = [-across * sin + 3e-4, across * cos - 2e-4];
        let centre = point([along * cos, along * sin], velocity, MASSES[k]);
        let body = Rigid::new(C::from(centre), ratio(INERTIAS[k])).unwrap();
        let body = body.with_angle(Angle::turns(ratio(spread(2 * i + k + 7) - 0.5)));
        let spin = ratio(0.6 * spread(2 * i + k + 99) - 0.3);
        body.with_spin(spin).unwrap()
    };
    let share = [-MASSES[1] / total, MASSES[0] / total];
    world([
        body(0, 3.0 * share[0], 2.0 * share[0]),
        body(1, 3.0 * share[1], 2.0 * share[1]),
    ])
}

fn spring<B: Rotating>(world: &World<B, 2>) -> impl Force<B> + use<B> {
    let attached = Attached {
        spring: Spring::new(ratio(1.7), ratio(STIFFNESS), 0).unwrap(),
        at: [vector(0.4, 0.3), vector(-0.3, 0.4)],
    };
    Pairs::new(attached, [[world.ids()[0], world.ids()[1]]])
}

/// Changes of linear and angular momentum at each count, and of what sizes.
struct Run {
    linear: [f64; 7],
    angular: [f64; 7],
    sizes: Sizes,
}

fn run<C: Kind>(i: usize) -> Run {
    let mut world = pair::<C>(i);
    let (mut spring, step) = (spring(&world), Step::hz(60).unwrap());
    let (p, l) = (world.momentum(), world.angular_momentum(Vec2::ZERO));
    let mut run = Run {
        linear: [0.0; 7],
        angular: [0.0; 7],
        sizes: Sizes::default(),
    };
    let mut done = 0;
    for (k, &count) in COUNTS.iter().enumerate() {
        while done < count {
            world.step(&mut Verlet, &mut spring, &step);
            if done % 61 == 0 {
                run.sizes.see(&world);
            }
            done += 1;
        }
        let change = world.momentum() - p;
        run.linear[k] = maximum(&[change.x.abs(), change.y.abs()]);
        run.angular[k] = (world.angular_momentum(Vec2::ZERO) - l).abs();
    }
    run
}

/// The power of N in medians at the counts.
fn power(medians: &[f64]) -> f64 {
    let middle = (COUNTS.len() as f64 - 1.0) / 2.0;
    let x = |k: usize| 0.5 * (k as f64 - middle);
    let (mut sum, mut spread) = (0.0, 0.0);
    for (k, median) in medians.iter().enumerate() {
        sum += x(k) * median.log10();
        spread += x(k) * x(k);
    }
    sum / spread
}

/// A median of 24 magnitudes of a normal number is off by `1 / (2 p sqrt(24))`, p = 0.636 its density there:
/// 0.16 of a deviation, 0.238 of itself, 0.103 decades. A line through seven, half a decade apart, has a slope off
/// by 0.103 / sqrt(7) = 0.039 if they are independent. Three and a half standard deviations: 0.14.
const WINDOW: std::ops::RangeInclusive<f64> = 0.36..=0.64;

/// Five standard deviations of the walk at each count, and the power by which it grows.
fn check<C: Kind>(walks: [bool; 2]) {
    let runs: Vec<Run> = (0..STARTS).map(run::<C>).collect();
    for (what, angular) in [("linear", false), ("angular", true)] {
        let of = |run: &Run, k: usize| {
            if angular {
                run.angular[k]
            } else {
                run.linear[k]
            }
        };
        let mut medians = [0.0; 7];
        for (k, &count) in COUNTS.iter().enumerate() {
            let share = |run: &Run| {
                let step = if angular {
                    C::angular(&run.sizes)
                } else {
                    C::linear(&run.sizes)
                };
                // As read at the start and now.
                let unseen = 2.0 * C::unseen(&run.sizes)[angular as usize];
                of(run, k) / (5.0 * f64::from(count).sqrt() * step + unseen)
            };
            let shares: Vec<f64> = runs.iter().map(share).collect();
            let what = format!("{} {what}, {count} steps, of 5 deviations", C::name());
            within(1.0, &what, &shares);
            let found: Vec<f64> = runs.iter().map(|run| of(run, k)).collect();
            medians[k] = median(&found);
        }
        let grows = power(&medians);
        println!(
            "{} {what} momentum: {:.1e} at the end, power {grows:.2}",
            C::name(),
            medians[6]
        );
        assert!(
            !walks[angular as usize] || WINDOW.contains(&grows),
            "{what}: {grows}"
        );
    }
}

#[test]
fn momenta_walk_in_i16f16() {
    check::<Point<I16F16>>([true, true]);
}

#[test]
fn momenta_walk_in_i8f24() {
    check::<Point<I8F24>>([true, true]);
}

#[test]
fn momenta_walk_in_f32() {
    check::<Point<f32>>([true, true]);
}

#[test]
fn bodies_that_carry_keep_one_and_walk_less_by_the_other() {
    check::<Carried<I16F16>>([false, true]);
    check::<Carried<I8F24>>([false, true]);
}
