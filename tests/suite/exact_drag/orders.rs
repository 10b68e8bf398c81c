//! Drag beside other forces: the order of the splitting, and the terminal speed that it makes.
//!
//! With `d = exp(-k h / m)`, a steady fall has
//!
//! ```text
//! SemiImplicitEuler   v = (v + g h) d                     v = g h d/(1 - d)
//! Verlet              v = (v sqrt(d) + g h) sqrt(d)       v = g h sqrt(d)/(1 - d)
//! ```
//!
//! at the ends of steps, where `m g / k` is the exact speed: less by `k h / 2 m` of itself, and less by
//! `(k h / m)²/24`.

use super::flight::{Driven, flight};
use super::{RATE, coefficients, grid, parts};
use crate::support::*;
use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{Anchor, Decay, ExactDrag, ExactQuadraticDrag, Force, GravityY, PerBody, Point};
use fixstep::{Step, Time, Vec2};

/// A part loses one unit too much at most, or two floats' roundings, and the next forgets l of it;
/// gravity's units are spread to within one. The coefficients count for all that is gained and lost.
fn check_terminal<S: Format + Decay>() {
    for scheme in SCHEMES {
        let p = f64::from(parts(scheme));
        let shares = grid(0.01, 100.0, 20).map(|x| {
            let g: S = scalar(-9.81);
            let drag = ExactDrag::new(ratio(2.0 * x * RATE)).unwrap();
            let mut forces = (GravityY::new(ratio(-9.81)).unwrap(), drag);
            let mut world = world([point::<S>([0.0; 2], [0.0; 2], 2.0)]);
            let (mut method, step) = (scheme.method(), Step::hz(RATE as i32).unwrap());
            for _ in 0..(40.0 / x) as u32 + 1 {
                world.step(&mut method, &mut forces, &step);
            }
            let gain = -g.to_f64() / RATE;
            let speed = gain * (-x / p).exp() / -(-x).exp_m1();
            let most = speed + gain;
            let bound =
                S::unit(most) * (2.0 / -(-x / p).exp_m1() + 1.0) + coefficients::<S>() * most;
            (-world.bodies()[0].velocity().y.to_f64() - speed).abs() / bound
        });
        let name = format!("{} {scheme:?} terminal speed, of its bound", S::name());
        within(1.0, &name, &shares.collect::<Vec<_>>());
    }
}

#[test]
fn terminal_speeds_are_those_of_the_splitting() {
    check_terminal::<f64>();
    check_terminal::<f32>();
    check_terminal::<I16F16>();
    check_terminal::<I8F24>();
}

/// A body of an order test.
#[derive(Clone, Copy)]
struct Start {
    x: f64,
    v: f64,
    mass: f64,
    /// `k / m`, and `c / m` per metre.
    rate: f64,
    quadratic: f64,
}

fn starts() -> [Start; 16] {
    std::array::from_fn(|i| Start {
        x: 2.0 + 3.0 * spread(i),
        v: 2.0 + 6.0 * spread(i + 20),
        mass: 0.2 * 100.0_f64.powf(spread(i + 40)),
        rate: 0.5 + 2.5 * spread(i + 60),
        quadratic: 0.1 + 0.3 * spread(i + 80),
    })
}

/// The state after a second.
fn after(scheme: Scheme, rate: i32, start: &Start, mut forces: impl Force<Point<f64>>) -> [f64; 2] {
    let mut world = world::<_, 1>([point([start.x, 0.0], [start.v, 0.0], start.mass)]);
    let (mut method, step) = (scheme.method(), Step::hz(rate).unwrap());
    for _ in 0..rate {
        world.step(&mut method, &mut forces, &step);
    }
    let body = world.bodies()[0];
    [body.position().x, body.velocity().x]
}

/// By how much the order, from the errors at 512 and 1024 steps, is not that of `scheme`. The next
/// term is a part of the first of about rate times h, 0.01 for all rates here, and its square where the
/// step is its own mirror image: 0.05 and 0.005 leave room for sixteen ratios of coefficients.
fn check_order(what: &str, scheme: Scheme, error: impl Fn(i32, &Start) -> f64) {
    let (order, bound) = match scheme {
        Scheme::Verlet | Scheme::ConstantAcceleration => (2.0, 0.005),
        _ => (1.0, 0.05),
    };
    let off =
        starts().map(|start| ((error(512, &start) / error(1024, &start)).log2() - order).abs());
    within(
        bound,
        &format!("{what}, order of {scheme:?} less {order}"),
        &off,
    );
}

fn drag(start: &Start) -> ExactDrag<f64> {
    ExactDrag::new(ratio(start.rate * start.mass)).unwrap()
}

#[test]
fn a_fall_with_drag_is_of_the_methods_order() {
    for scheme in SCHEMES {
        check_order("fall", scheme, |rate, start| {
            let wind = PerBody(|_: Time, body: &Point<f64>| {
                Vec2::new(-9.81 / fixstep::Body::inv_mass(body), 0.0)
            });
            let [x, v] = after(scheme, rate, start, (wind, drag(start)));
            let exact = flight(start.rate, 1.0, [start.x, start.v], -9.81);
            (x - exact[0]).hypot(v - exact[1])
        });
    }
}

#[test]
fn a_driven_spring_with_drag_is_of_the_methods_order() {
    for scheme in [Scheme::SemiImplicitEuler, Scheme::Verlet] {
        check_order("driven spring", scheme, |rate, start| {
            let driven = Driven {
                w: 3.0,
                damping: start.rate,
                push: 8.0,
                drive: 2.0,
            };
            let newtons = 8.0 * start.mass;
            let push = PerBody(move |time: Time, _: &Point<f64>| {
                Vec2::new(newtons * (2.0 * time.seconds::<f64>()).cos(), 0.0)
            });
            let id = world::<_, 1>([point::<f64>([0.0; 2], [0.0; 2], 1.0)]).ids()[0];
            let anchor = Anchor::new(id, Vec2::ZERO, ratio(9.0 * start.mass), 0).unwrap();
            let [x, v] = after(scheme, rate, start, (push, anchor, drag(start)));
            let exact = driven.at(1.0, [start.x, start.v]);
            (x - exact[0]).hypot(v - exact[1])
        });
    }
}

/// `m v' = -k v - c v²`, whose `1/v` is linear: `v = v0 E/(1 + c v0 (1 - E)/k)` with `E = exp(-k t / m)`.
#[test]
fn two_drags_are_of_the_methods_order() {
    for scheme in SCHEMES {
        for first in [true, false] {
            check_order("two drags", scheme, |rate, start| {
                let linear = drag(start);
                let air = ExactQuadraticDrag::new(ratio(start.quadratic * start.mass)).unwrap();
                let [_, v] = match first {
                    true => after(scheme, rate, start, (linear, air)),
                    false => after(scheme, rate, start, (air, linear)),
                };
                let left = (-start.rate).exp();
                let slowed = 1.0 + start.quadratic / start.rate * start.v * (1.0 - left);
                (v - start.v * left / slowed).abs()
            });
        }
    }
}
