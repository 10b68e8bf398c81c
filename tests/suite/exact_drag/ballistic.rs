//! `Ballistic` against the closed form, after 4 steps and after 240.
//!
//! A part of a step takes the loss l and adds `φ1 h g`; `s = (1 - (1 - l)^n)/l` parts of n are not
//! forgotten. V and X are the largest speed and distance, u a unit there:
//!
//! ```text
//! v    a part: the loss, one unit in fixed point; two sums in floats          1.5 u s
//!      gravity's units, spread over the parts, are one off, and start anew    u
//!      coefficients, of all that was lost and gained                          8 C V
//!      φ1, 16 C of itself in floats, of 1 in fixed point                      16 C h g φ1 s
//! x    a part: rounds the way and the sum, spreads gravity                    u n + u
//!      the v above, for φ1 h each                                             φ1 h n
//!      coefficients of the way                                                24 C (way)
//!      φ1 of v, φ2 of h g, as above                                           16 C h n (V + h g)
//! ```
//!
//! C is `COEFFICIENT`: 1.5 epsilons of a coefficient in fixed point and 3 in floats, so that the 8
//! epsilons of a loss and of fixed φ, and the 32 of φ in floats, are within. The reference rounds
//! by less: a unit of `f64` more of each.

use super::flight::{decay, flight};
use super::{RATE, floats, grid};
use crate::support::*;
use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{
    Ballistic, Body, Decay, Force, Method, PerBody, Point, SemiImplicitEuler, Step, Time,
};
use fixstep::{Vec2, Verlet, scalar::Factor};

/// Where a body starts, its mass, and `k h / m`.
#[derive(Clone, Copy, Debug)]
struct Throw {
    x: f64,
    v: f64,
    g: f64,
    mass: f64,
    rate: f64,
}

impl Throw {
    /// 24 throws: from 1e-6 to 100 in `k h / m`, and one without drag. All stay within 100 m.
    fn all() -> impl Iterator<Item = Throw> {
        let rates = grid(1e-6, 100.0, 23).chain([0.0]);
        rates.enumerate().map(|(i, x)| Throw {
            x: 20.0 * (spread(i) - 0.5),
            v: 20.0 * (spread(i + 40) - 0.5),
            g: -9.81 * (0.1 + 0.7 * spread(i + 80)),
            mass: 0.1 * 300.0_f64.powf(spread(i + 120)),
            rate: x,
        })
    }
}

/// Errors of position and velocity over their bounds after `steps`, and relative to X and V.
fn errors<S, M>(mut method: M, parts: f64, throw: &Throw, steps: u32) -> ([f64; 2], [f64; 2])
where
    S: Format + Decay,
    M: Method<Point<S>, 1>,
{
    let body = point::<S>([throw.x, 0.0], [throw.v, 0.0], throw.mass);
    let g = vector::<S>(throw.g, 0.0);
    let k = ratio(throw.rate * throw.mass * RATE);
    let mut flying = Ballistic::new(g, k).unwrap();
    let (mut world, step) = (world([body]), Step::hz(RATE as i32).unwrap());
    let (start, g) = (
        [body.position().x.to_f64(), body.velocity().x.to_f64()],
        g.x.to_f64(),
    );
    let per_second = k.to_f64() * Factor::<S>::to_f64(body.inv_mass());
    for _ in 0..steps {
        world.step(&mut method, &mut flying, &step);
    }
    let got = [
        world.bodies()[0].position().x.to_f64(),
        world.bodies()[0].velocity().x.to_f64(),
    ];
    let (n, h) = (parts * f64::from(steps), 1.0 / RATE / parts);
    let t = n * h;
    let exact = flight(per_second, t, start, g);
    let ([lost, mean, mean_loss], [part, inner, _]) =
        (decay(per_second * t), decay(per_second * h));
    let kept = if part > 0.0 { lost / part } else { n };
    let speed = start[1].abs() + mean * t * g.abs();
    let way = t * (mean * start[1].abs() + t * mean_loss * g.abs());
    let far = start[0].abs() + way;
    let (u, c) = (S::unit(speed), S::COEFFICIENT);
    let weight = if floats::<S>() { inner } else { 1.0 };
    let v = 1.5 * u * kept + u + 8.0 * c * speed + 16.0 * c * h * g.abs() * weight * kept;
    let weighed = 16.0 * c * h * n * weight * (speed + h * g.abs());
    let x = S::unit(far) * (n + 1.0) + inner * h * n * v + 24.0 * c * way + weighed;
    let bounds = [x + far * f64::EPSILON, v + speed * f64::EPSILON];
    let off = [0, 1].map(|i| (got[i] - exact[i]).abs());
    (
        [off[0] / bounds[0], off[1] / bounds[1]],
        [off[0] / far, off[1] / speed],
    )
}

fn check<S: Format + Decay>() {
    for steps in [4, 240] {
        let runs = [1.0, 2.0].map(|parts| {
            let run = |throw: Throw| match parts == 1.0 {
                true => errors::<S, _>(SemiImplicitEuler, parts, &throw, steps),
                false => errors::<S, _>(Verlet, parts, &throw, steps),
            };
            (parts, Throw::all().map(run).collect::<Vec<_>>())
        });
        for (parts, runs) in runs {
            let method = if parts == 1.0 {
                "SemiImplicitEuler"
            } else {
                "Verlet"
            };
            for (i, what) in ["position", "velocity"].into_iter().enumerate() {
                let shares: Vec<f64> = runs.iter().map(|run| run.0[i]).collect();
                let relative: Vec<f64> = runs.iter().map(|run| run.1[i]).collect();
                let name = format!("{} {method} {what} after {steps}", S::name());
                within(1.0, &format!("{name}, of its bound"), &shares);
                println!(
                    "{name}: relatively {:.1e}, {:.1e} at most",
                    median(&relative),
                    maximum(&relative)
                );
                // n is 8 and 480 with two parts a step: the sum of all terms is below
                // 130 and 1400 epsilons, of which 1.5 u s and u n are 20 and 1201.
                if S::name() == "f64" {
                    let bound = if steps == 4 { 130.0 } else { 1400.0 };
                    let name = format!("{name}, relatively");
                    within(bound * f64::EPSILON, &name, &relative);
                }
            }
        }
    }
}

#[test]
fn flights_are_exact_to_rounding() {
    check::<f64>();
    check::<f32>();
    check::<I16F16>();
    check::<I8F24>();
}

/// From rest, until nothing of it is left: `m g / k`.
fn check_terminal<S: Format + Decay>(mut method: impl Method<Point<S>, 1>, parts: f64) {
    let shares = grid(0.01, 100.0, 20).map(|x| {
        let g = vector::<S>(0.0, -9.81);
        let mut flying = Ballistic::new(g, ratio(2.0 * x * RATE)).unwrap();
        let mut world = world([point::<S>([0.0; 2], [0.0; 2], 2.0)]);
        let step = Step::hz(RATE as i32).unwrap();
        let (h, terminal) = (1.0 / RATE / parts, g.y.to_f64() / x / RATE);
        let [part, inner, _] = decay(x / parts);
        // exp(-40) of it is left.
        for _ in 0..(40.0 / x) as u32 + 1 {
            world.step(&mut method, &mut flying, &step);
        }
        let (u, c) = (S::unit(terminal.abs()), S::COEFFICIENT);
        let weight = if floats::<S>() { inner } else { 1.0 };
        let bound =
            1.5 * u / part + u + 8.0 * c * terminal.abs() + 16.0 * c * h * 9.81 * weight / part;
        (world.bodies()[0].velocity().y.to_f64() - terminal).abs() / bound
    });
    let name = format!("{} terminal speed in {parts}, of its bound", S::name());
    within(1.0, &name, &shares.collect::<Vec<_>>());
}

#[test]
fn a_flight_ends_at_the_terminal_speed() {
    check_terminal::<f64>(SemiImplicitEuler, 1.0);
    check_terminal::<f64>(Verlet, 2.0);
    check_terminal::<f32>(SemiImplicitEuler, 1.0);
    check_terminal::<f32>(Verlet, 2.0);
    check_terminal::<I16F16>(SemiImplicitEuler, 1.0);
    check_terminal::<I16F16>(Verlet, 2.0);
    check_terminal::<I8F24>(SemiImplicitEuler, 1.0);
    check_terminal::<I8F24>(Verlet, 2.0);
}

/// Error at one second with a wind that is kicked beside the flight, in position and velocity.
fn windy(mut method: impl Method<Point<f64>, 1>, rate: i32, throw: &Throw) -> f64 {
    let wind = PerBody(|_: Time, _: &Point<f64>| Vec2::new(3.0, 0.0));
    let k = throw.mass * (0.5 + throw.x.abs());
    let flying = Ballistic::new(vector(throw.g, 0.0), ratio(k)).unwrap();
    let (mut world, mut forces) = (
        world([point([throw.x, 0.0], [throw.v, 0.0], throw.mass)]),
        (flying, wind),
    );
    fly(&mut world, &mut method, &mut forces, rate);
    let g = throw.g + 3.0 / throw.mass;
    let [x, v] = flight(k / throw.mass, 1.0, [throw.x, throw.v], g);
    let (got, speed) = (
        world.bodies()[0].position().x,
        world.bodies()[0].velocity().x,
    );
    (got - x).hypot(speed - v)
}

fn fly(
    world: &mut fixstep::World<Point<f64>, 1>,
    method: &mut impl Method<Point<f64>, 1>,
    forces: &mut impl Force<Point<f64>>,
    rate: i32,
) {
    let step = Step::hz(rate).unwrap();
    for _ in 0..rate {
        world.step(method, forces, &step);
    }
}

#[test]
fn a_wind_beside_the_flight_is_of_the_methods_order() {
    let throws: Vec<Throw> = Throw::all().collect();
    let order = |error: &dyn Fn(i32, &Throw) -> f64| -> Vec<f64> {
        throws
            .iter()
            .map(|throw| (error(512, throw) / error(1024, throw)).log2())
            .collect()
    };
    let off = |orders: Vec<f64>, p: f64| {
        orders
            .into_iter()
            .map(|o| (o - p).abs())
            .collect::<Vec<_>>()
    };
    // With k / m up to 10.5 the next term is about k h / m = 0.02 of the first, squared under Verlet.
    let semi = order(&|rate, throw| windy(SemiImplicitEuler, rate, throw));
    within(0.05, "order of SemiImplicitEuler less 1", &off(semi, 1.0));
    let verlet = order(&|rate, throw| windy(Verlet, rate, throw));
    within(0.01, "order of Verlet less 2", &off(verlet, 2.0));
}
