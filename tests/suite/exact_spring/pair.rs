//! `ExactPair`: two bodies about their centre against the exact solution, and what they do to each
//! other.

use fixstep::fixed::types::{I8F24, I12F20, I16F16};
use fixstep::{
    Body, Decay, ExactPair, Factor, Point, Ratio, Scalar, Step, TimeStep, Vec2, World, dec,
};

use crate::exact_spring::flow::{Double, step_of};
use crate::exact_spring::rounding::is_fixed;
use crate::exact_spring::splitting::{SPLITTINGS, Splitting};
use crate::support::*;

const STEPS: u32 = 120;
const REST: [f64; 2] = [1.25, -0.5];

/// A point that remembers its last two pushes and counts them and kicks.
#[derive(Clone, Copy, Debug)]
struct Probe<S: Scalar> {
    point: Point<S>,
    last: [Vec2<S>; 2],
    pushes: u32,
    kicks: u32,
}

impl<S: Scalar> Body for Probe<S> {
    type S = S;
    type Spin = fixstep::body::NoSpin;

    fn position(&self) -> Vec2<S> {
        self.point.position()
    }

    fn velocity(&self) -> Vec2<S> {
        self.point.velocity()
    }

    fn inv_mass(&self) -> S::InvMass {
        self.point.inv_mass()
    }

    fn kick(&mut self, dv: Vec2<S>) {
        self.kicks += 1;
        self.point.kick(dv);
    }

    fn push(&mut self, impulse: Vec2<S>) {
        self.pushes += 1;
        self.last = [impulse, self.last[0]];
        self.point.push(impulse);
    }

    fn shift(&mut self, dx: Vec2<S>) {
        self.point.shift(dx);
    }

    fn drift(&mut self, step: &impl TimeStep<S>) {
        self.point.drift(step);
    }

    fn drift_half(&mut self, step: &impl TimeStep<S>) {
        self.point.drift_half(step);
    }
}

/// Masses, spring and size of start `i`.
struct Case {
    masses: [f64; 2],
    hertz: Ratio,
    omega: f64,
    amplitude: f64,
}

/// Where the centre moves to, m/s.
const CENTRE: [f64; 2] = [0.6, -0.35];

impl Case {
    /// 0.4 to 20 Hz; velocities up to 20 m/s.
    fn new(masses: [f64; 2], i: usize) -> Case {
        let hertz = ratio(0.4 * 50.0_f64.powf(spread(5 * i)));
        let omega = std::f64::consts::TAU * hertz.to_f64();
        Case {
            masses,
            hertz,
            omega,
            amplitude: (20.0 / omega).min(0.8),
        }
    }

    fn world<S: Format>(&self, i: usize) -> World<Probe<S>, 2> {
        let ([m1, m2], a) = (self.masses, self.amplitude);
        let (sin, cos) = angle(i).sin_cos();
        let (d, w) = (
            [a * cos, -a * sin],
            [self.omega * a * sin, self.omega * a * cos],
        );
        let body = |share: f64, mass| {
            let x = std::array::from_fn(|k| share * (d[k] + REST[k]));
            let v = std::array::from_fn(|k| CENTRE[k] + share * w[k]);
            Probe {
                point: point(x, v, mass),
                last: [Vec2::ZERO; 2],
                pushes: 0,
                kicks: 0,
            }
        };
        let total = m1 + m2;
        world([body(-m2 / total, m1), body(m1 / total, m2)])
    }

    /// What one flow is off by: the difference in (x, v/ω), the centre in x, and in v.
    ///
    /// Each body rounds its drift and three products: half a unit each, in floats the sums as well. The
    /// impulse is two products, its unit is felt through 1/μ, and each velocity rounds once more. Up to
    /// twelve coefficients of three roundings each take part: shares, masses and products with h.
    fn of_flow<S: Format>(&self) -> [f64; 3] {
        let [m1, m2] = self.masses;
        let (reduced, speed) = (m1 * m2 / (m1 + m2), 2.0 * self.omega * self.amplitude);
        let (x, v) = (S::unit(4.0), S::unit(speed + 0.7));
        let impulse = S::unit(2.0 * reduced * speed) / reduced;
        let sums = if is_fixed::<S>() { 1.0 } else { 2.0 };
        let coefficients = 12.0 * S::COEFFICIENT * (self.amplitude + 0.7 / 60.0);
        let difference = sums * (4.0 * x + (v + impulse) / self.omega) + coefficients;
        [difference, sums * 2.0 * x + coefficients, 0.5 * sums * v]
    }
}

/// Difference and centre of both axes as (x, v/ω) and (x, v).
fn motion<S: Format>(world: &World<Probe<S>, 2>, omega: Double) -> [[[Double; 2]; 2]; 2] {
    let [a, b] = [0, 1].map(|i| &world.bodies()[i]);
    let of = |v: Vec2<S>| v.to_f64().array().map(Double::of);
    let [xa, xb, va, vb] = [a.position(), b.position(), a.velocity(), b.velocity()].map(of);
    // Shares of the masses as the bodies hold them: w2 / (w1 + w2).
    let [wa, wb] = [a, b].map(|body| Double::of(body.inv_mass().to_f64()));
    let (sa, sb) = (wb / (wa + wb), wa / (wa + wb));
    let axis = |k: usize| [xb[k] - xa[k] - Double::of(REST[k]), (vb[k] - va[k]) / omega];
    let centre = |k: usize| [sa * xa[k] + sb * xb[k], sa * va[k] + sb * vb[k]];
    [[axis(0), axis(1)], [centre(0), centre(1)]]
}

/// Largest errors of difference and centre in a run, in parts of what is allowed by then. In each step
/// the impulses sum to zero to the bit.
fn run<S: Format + Decay>(
    mut scheme: Splitting,
    zeta: Ratio,
    masses: [f64; 2],
    i: usize,
) -> [f64; 2] {
    let case = Case::new(masses, i);
    let mut world = case.world::<S>(i);
    let (step, rest) = (Step::<S>::hz(60).unwrap(), vector(REST[0], REST[1]));
    let ids = [world.ids()[0], world.ids()[1]];
    let mut pair = ExactPair::<S>::new(ids, rest, case.hertz, zeta).unwrap();
    let (omega, flow) = step_of(case.hertz, zeta, step.seconds());
    let [mut swing, centre] = motion(&world, omega);
    let (each, flows, mut worst) = (case.of_flow::<S>(), scheme.flows(), [0.0; 2]);
    for tick in 1..=STEPS {
        world.step(&mut scheme, &mut pair, &step);
        let [a, b] = [0, 1].map(|i| &world.bodies()[i]);
        assert_eq!(a.last, b.last.map(|push| -push));
        assert_eq!(
            [a.pushes, b.pushes, a.kicks, b.kicks],
            [tick * flows as u32, tick * flows as u32, 0, 0]
        );
        swing = swing.map(|axis| flow.of(axis));
        let [now, now_centre] = motion(&world, omega);
        let n = tick as f64 * flows;
        // The centre's velocity is off by more in each step, and its place by the sum of that.
        let drifted = each[1] * n + each[2] * n * tick as f64 / 120.0;
        for k in 0..2 {
            let off = |i: usize| (now[k][i] - swing[k][i]).to_f64();
            let time = Double::of(tick as f64) * Double::ratio(step.seconds());
            let apart = now_centre[k][0] - (centre[k][0] + time * centre[k][1]);
            worst[0] = maximum(&[worst[0], off(0).hypot(off(1)) / (n * each[0])]);
            worst[1] = maximum(&[worst[1], apart.to_f64().abs() / drifted]);
        }
    }
    worst
}

fn check<S: Format + Decay>() {
    const DAMPING: [Ratio; 3] = [dec!(0), dec!(0.2), dec!(1.5)];
    for masses in [[1.0, 3.0], [1.37, 2.91], [1.0, 1000.0]] {
        for scheme in SPLITTINGS {
            let run = |i: usize| run::<S>(scheme, DAMPING[i % 3], masses, i / 3);
            let errors: [_; 48] = std::array::from_fn(run);
            let what = |part| format!("{} {scheme:?} {masses:?} kg, {part}, of it", S::name());
            within(1.0, &what("swing"), &errors.map(|error| error[0]));
            within(1.0, &what("centre"), &errors.map(|error| error[1]));
        }
    }
}

#[test]
fn a_pair_in_floats_follows_the_exact_solution() {
    check::<f64>();
    check::<f32>();
}

#[test]
fn a_pair_in_fixed_point_follows_the_exact_solution() {
    check::<I16F16>();
    check::<I12F20>();
    check::<I8F24>();
}
