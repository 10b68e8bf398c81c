//! A rotor with a motor and a bearing, `I ω' = M - c ω`, and what a method makes of it.
//!
//! ```text
//! continuous    s∞ = M / 2πc                 s(t) = s∞ + (s0 - s∞) exp(-c t / I)
//! a step        e = exp(-x), x = c h / I;  g = x s∞ is what M gives in a step
//!   kick, damp              s' = (s + g) e           rests at  g e / (1 - e)  = s∞ x / (exp(x) - 1)
//!   half, kick, half        s' = s e + g sqrt(e)     rests at  g sqrt(e) / (1 - e) = s∞ (x/2) / sinh(x/2)
//! after n steps s_n = r + (s0 - r) e^n, r that rest: at any x
//! ```
//!
//! `rotor/torsion.rs` has a spring of the scene's own.

use crate::support;
#[path = "rotor/torsion.rs"]
mod torsion;

use std::f64::consts::TAU;
use std::fmt::Debug;

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::rigid::Centre;
use fixstep::rigid::torque::{SpinDrag, Torque};
use fixstep::{
    Body, Carried, CarryAngular, Decay, Factor, Point, Rigid, Rotating, Scalar, Step, Vec2, World,
};
use support::*;

const RATE: f64 = 60.0;

/// So small that a motor of 75 N m holds a turn a second against `x = 100`.
const INERTIA: f64 = 0.002;

const PARTS: [f64; 5] = [0.01, 0.1, 1.0, 10.0, 100.0];

/// A number type, and one rounding of a coefficient or of 1 in it.
trait Rounds: Format + Decay + CarryAngular {
    const ROUNDING: f64;

    /// Whether sums are rounded.
    const SUMS: bool = false;
}

impl Rounds for I16F16 {
    const ROUNDING: f64 = 1.0 / (1_u64 << 30) as f64;
}

impl Rounds for I8F24 {
    const ROUNDING: f64 = 1.0 / (1_u64 << 30) as f64;
}

impl Rounds for f32 {
    const ROUNDING: f64 = 0.5 * f32::EPSILON as f64;
    const SUMS: bool = true;
}

impl Rounds for f64 {
    const ROUNDING: f64 = 0.5 * f64::EPSILON;
    const SUMS: bool = true;
}

/// A centre of mass, and how far a damped spin of its rotor may be off, in units.
trait Middle: Centre<S: Rounds> + From<Point<Self::S>> + Debug {
    /// Half a unit, or up to one where the loss would round to nothing; a float rounds the loss, which is at most
    /// the spin, and what is left.
    const DAMPED: f64;

    /// Half a unit where a remainder is not seen.
    const SEEN: f64;

    /// How many parts of a unit it can still turn by.
    const FINEST: f64;
}

impl<S: Rounds> Middle for Point<S> {
    const DAMPED: f64 = 1.0;
    const SEEN: f64 = 0.0;
    const FINEST: f64 = 1.0;
}

/// Units of 2^-15. The remainder loses a product of its own.
impl<S: Rounds> Middle for Carried<S> {
    const DAMPED: f64 = 1.5 / 32768.0;
    const SEEN: f64 = 0.5;
    const FINEST: f64 = 1.0 / 32768.0;
}

fn wheel<C: Middle>(spin: f64, inertia: f64) -> Rigid<C> {
    let centre = Point::new(Vec2::ZERO, Vec2::ZERO, 1).unwrap();
    let body = Rigid::new(C::from(centre), ratio(inertia)).unwrap();
    body.with_spin(ratio(spin)).unwrap()
}

/// The drag of a bearing with that `c h / I`, N m s.
fn drag(x: f64) -> f64 {
    x * INERTIA * RATE
}

/// Whether a method damps once, after its kick; and its kicks.
fn once(scheme: Scheme) -> bool {
    matches!(scheme, Scheme::Euler | Scheme::SemiImplicitEuler)
}

fn kicks(scheme: Scheme) -> f64 {
    if matches!(scheme, Scheme::Rk4 | Scheme::Pefrl) {
        4.0
    } else {
        1.0
    }
}

/// How far a spin may be off that stays below `most`, at any step.
///
/// What a step adds to an error, e times is left of in the next: `1 / (1 - e)` of it in all. That is each damping's
/// rounding, in floats each kick's too. The fixed-point gain of a torque is spread over the ticks: its
/// first n add up to n times the exact one but for half a unit, so that, weighed by powers of e, they are off by
/// a unit for each kick at most. The loss is off by 8 roundings of its own (`exact_drag/exponential.rs`) and
/// by those of x, eight: c, 2π, h, I and their products; it counts as a part of the spin, twice as there may be
/// two halves. Three roundings of the gain are a part of where it leads.
fn allowed<C: Middle>(scheme: Scheme, x: f64, most: f64) -> f64 {
    let (damped, kicks) = (if once(scheme) { 1.0 } else { 2.0 }, kicks(scheme));
    let sums = if C::S::SUMS { 0.5 * kicks } else { 0.0 };
    let in_all = (damped * C::DAMPED + sums) / -(-x).exp_m1();
    C::S::unit(most) * (in_all + kicks + C::SEEN) + 35.0 * C::S::ROUNDING * most
}

/// From two turns a second to the end, by the closed form of the splitting at each step. Prints where it ends as a
/// part of the continuous `s∞`.
fn check_motor<C: Middle>(scheme: Scheme, x: f64) {
    let mut world = world([wheel::<C>(2.0, INERTIA)]);
    let (inverse, c) = (world.bodies()[0].inv_inertia().to_f64(), drag(x));
    let torque: C::S = scalar(TAU * c);
    let body = world.ids()[0];
    let mut forces = (Torque { body, torque }, SpinDrag::new(ratio(c)).unwrap());
    let (mut method, step) = (scheme.method(), Step::hz(60).unwrap());
    let (x, terminal) = (TAU * c * inverse / RATE, torque.to_f64() / (TAU * c));
    let of_terminal = match once(scheme) {
        true => x / x.exp_m1(),
        false => (0.5 * x) / (0.5 * x).sinh(),
    };
    let rest = terminal * of_terminal;
    let bound = allowed::<C>(scheme, x, 2.0);
    let mut worst = 0.0;
    let steps = (16.0 / x) as i32 + 40;
    for n in 1..=steps {
        world.step(&mut method, &mut forces, &step);
        let exact = rest + (2.0 - rest) * (-x * f64::from(n)).exp();
        let error = (world.bodies()[0].spin_momentum() * inverse - exact).abs();
        worst = maximum(&[worst, error]);
        assert!(
            error <= bound,
            "{scheme:?} {x}: {error:e} > {bound:e}, step {n}"
        );
    }
    // A ten-millionth of the start is left.
    let end = world.bodies()[0].spin().to_f64() / terminal;
    assert!((end - of_terminal).abs() <= (bound + 4e-7) / terminal);
    println!(
        "{:<7} {scheme:?} c h / I = {x:<7.2}: M / 2πc times {end:.6} (splitting {of_terminal:.6}), off by \
         {worst:.1e} of {bound:.1e} turns/s",
        C::S::name(),
    );
}

/// Sixteen spins that a bearing brakes, every other one with a third of the inertia: `s0 exp(-c t / I)` at each step, and in fixed point none in the end.
/// A part of a step takes a unit or more: once less than half a unit would be lost in it, `1 / 2 l` parts are
/// left.
fn check_bearing<C: Middle>(scheme: Scheme, x: f64) {
    let start = |i: usize| (4.0 * spread(i) + 0.1) * [-1.0, 1.0, 1.0][i % 3];
    let mut world = world(std::array::from_fn::<_, 16, _>(|i| {
        wheel::<C>(start(i), INERTIA / [1.0, 3.0][i % 2])
    }));
    let starts: Vec<f64> = world
        .bodies()
        .iter()
        .map(|body| body.spin().to_f64())
        .collect();
    let mut bearing = SpinDrag::new(ratio(drag(x))).unwrap();
    let (mut method, step) = (scheme.method(), Step::hz(60).unwrap());
    let of = |body: &Rigid<C>| TAU * drag(x) * body.inv_inertia().to_f64() / RATE;
    let parts: Vec<f64> = world.bodies().iter().map(of).collect();
    // The heavy ones are off by more, and rest later.
    let x = parts[0];
    let bound = allowed::<C>(scheme, x, 4.1);
    let part = if once(scheme) { x } else { 0.5 * x };
    let fine = C::S::unit(0.0) * C::FINEST;
    let steps = match C::S::SUMS {
        true => 10.0 / x,
        false => (4.1 / fine).ln() / x - 0.5 / (-part).exp_m1(),
    };
    let mut worst = [0.0; 16];
    for n in 1..=steps as i32 + 2 {
        world.step(&mut method, &mut bearing, &step);
        for (i, body) in world.bodies().iter().enumerate() {
            let exact = starts[i] * (-parts[i] * f64::from(n)).exp();
            let error = (body.spin().to_f64() - exact).abs();
            worst[i] = maximum(&[worst[i], error]);
        }
    }
    let what = format!("{} {scheme:?} c h / I = {x:.2}, turns/s", C::S::name());
    within(bound, &what, &worst);
    let turns = |body: &Rigid<C>| body.spin_momentum() != 0.0;
    assert!(
        C::S::SUMS || !world.bodies().iter().any(turns),
        "{what}: no rest"
    );
}

fn check<C: Middle>() {
    for scheme in ALL_SCHEMES {
        for x in PARTS {
            check_motor::<C>(scheme, x);
            check_bearing::<C>(scheme, x);
        }
    }
}

#[test]
fn a_motor_against_a_bearing_in_i16f16() {
    check::<Point<I16F16>>();
    check::<Carried<I16F16>>();
}

#[test]
fn a_motor_against_a_bearing_in_i8f24() {
    check::<Point<I8F24>>();
}

#[test]
fn a_motor_against_a_bearing_in_floats() {
    check::<Point<f32>>();
    check::<Point<f64>>();
}
