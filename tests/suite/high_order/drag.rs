//! Drag: explicit drag is of order 4 under Runge-Kutta, exact drag is applied by halves at both ends of a
//! step, which makes a scene of order 2.

use fixstep::{Anchor, Body, Force, LinearDrag, Now, Part, Point, Scalar, Step, TimeStep, World};

use super::ORDER_4;
use super::support::*;

const RATE: f64 = 1.3;
const MASS: f64 = 0.6;

/// Slope of ln(error) against ln(h) between two runs.
fn slope([coarse, fine]: [f64; 2], ratio: f64) -> f64 {
    (coarse / fine).ln() / ratio.ln()
}

/// Error of place and velocity after two seconds of drag alone:
/// `v = v0 e^(-γ t)`, `x = v0 (1 - e^(-γ t)) / γ`.
fn braked(rate: i32, i: usize) -> f64 {
    let v = [3.0 * angle(i).cos(), 3.0 * angle(i).sin()];
    let mut world: World<Point<f64>, 1> = world([point([0.0; 2], v, MASS)]);
    let mut drag = LinearDrag::new(ratio(RATE)).unwrap();
    let (mut method, step) = (Scheme::Rk4.method(), Step::hz(rate).unwrap());
    for _ in 0..2 * rate {
        world.step(&mut method, &mut drag, &step);
    }
    let gamma = RATE * world.bodies()[0].inv_mass();
    let decay = (-2.0 * gamma).exp();
    let (x, u) = (world.bodies()[0].position(), world.bodies()[0].velocity());
    let off = |axis: usize| {
        let path = v[axis] * (1.0 - decay) / gamma;
        (x.array()[axis] - path).hypot(u.array()[axis] - v[axis] * decay)
    };
    off(0).hypot(off(1))
}

/// The next term is `γ h` of the first: below 0.11 at 20 Hz, so it moves a slope between rates that differ
/// by 2 by `0.11 / (2 ln 2)`, 0.08. Rounding is 1e-15 of errors from 1e-9.
#[test]
fn explicit_drag_is_of_order_4_under_rk4() {
    let off = |i| (slope([20, 40].map(|rate| braked(rate, i)), 2.0) - 4.0).abs();
    let errors: [f64; 16] = std::array::from_fn(off);
    within(0.1, "Rk4 linear drag, slope less 4", &errors);
}

/// Linear drag that acts alone is solved exactly: a factor for each part of a step.
struct Exact {
    rate: f64,
    factors: [f64; 2],
}

impl<B: Body<S = f64>> Force<B> for Exact {
    const COUPLES: bool = false;

    fn prepare<H: TimeStep<f64>>(&mut self, now: &Now<H>) {
        let whole = (-self.rate * now.step.coef()).exp();
        self.factors = [whole, whole.sqrt()];
    }

    fn damp<H: TimeStep<f64>>(&mut self, _now: &Now<H>, part: Part, live: &mut B) {
        let factor = match part {
            Part::Whole => self.factors[0],
            _ => self.factors[1],
        };
        live.kick_by(live.velocity(), factor - 1.0);
    }
}

fn exact_drag() -> Exact {
    Exact {
        rate: RATE,
        factors: [f64::NAN; 2],
    }
}

// 120 products, each off by 1e-16 of the velocity.
#[test]
fn exact_drag_alone_is_exact() {
    for scheme in ORDER_4 {
        let errors: [f64; 16] = std::array::from_fn(|i| {
            let v = 3.0 * angle(i).cos();
            let mut world: World<Point<f64>, 1> = world([point([0.0; 2], [v, 1.0], MASS)]);
            let (mut method, step) = (scheme.method(), Step::hz(30).unwrap());
            for _ in 0..60 {
                world.step(&mut method, &mut exact_drag(), &step);
            }
            (world.bodies()[0].velocity().x - v * (-2.0 * RATE).exp()).abs()
        });
        within(1e-13, &format!("{scheme:?} exact drag alone"), &errors);
    }
}

/// Error after two seconds on a spring of 3 rad/s with that drag, underdamped:
/// `x = e^(-γ t/2) (x0 cos βt + (v0 + γ/2 x0) / β sin βt)`, `β² = ω² - γ²/4`.
fn damped_swing(scheme: Scheme, rate: i32, i: usize) -> f64 {
    let (x0, v0) = (angle(i).cos(), 3.0 * angle(i).sin());
    let mut world: World<Point<f64>, 1> = world([point([x0, 0.0], [v0, 0.0], 1.0)]);
    let anchors: [Anchor<f64>; 1] = anchors(&world, [9.0]);
    let mut forces = (anchors, exact_drag());
    let (mut method, step) = (scheme.method(), Step::hz(rate).unwrap());
    for _ in 0..2 * rate {
        world.step(&mut method, &mut forces, &step);
    }
    let (half, beta) = (RATE / 2.0, (9.0 - RATE * RATE / 4.0).sqrt());
    let (sin, cos) = (2.0 * beta).sin_cos();
    let side = (v0 + half * x0) / beta;
    let decay = (-2.0 * half).exp();
    let x = decay * (x0 * cos + side * sin);
    let v = decay * (beta * (side * cos - x0 * sin)) - half * x;
    let body = &world.bodies()[0];
    (body.position().x.minus(x)).hypot((body.velocity().x.minus(v)) / 3.0)
}

/// Halves at both ends are symmetric, so the next term is of `h²`: `(ω h)² = 0.006` of the first at 40 Hz
/// but for starts at which the first is small; phase space has none.
#[test]
fn exact_drag_beside_a_spring_is_of_order_2() {
    for scheme in ORDER_4 {
        let errors = |i| [40, 80].map(|rate| damped_swing(scheme, rate, i));
        let off = |i| (slope(errors(i), 2.0) - 2.0).abs();
        let slopes: [f64; 16] = std::array::from_fn(off);
        within(
            0.05,
            &format!("{scheme:?} exact drag, slope less 2"),
            &slopes,
        );
    }
}
