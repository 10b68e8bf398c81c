//! The law itself: against a method of fourth order with finer steps that shares no code with the
//! crate, and against the circular orbit of two bodies.

use fixstep::{Point, Step, World};

use crate::nbody::scene::*;
use crate::support::*;
use fixstep::fixed::types::{I8F24, I12F20, I16F16, I20F12};

/// `stars` after one step of the classical Runge-Kutta method.
fn runge_kutta(law: Law, stars: &[Star], h: f64) -> Vec<Star> {
    let slopes = |at: &[Star]| -> Vec<[[f64; 2]; 2]> {
        let forces = law.forces(at);
        let slope = |(star, force): (&Star, [f64; 2])| [star.v, force.map(|f| f / star.m)];
        at.iter().zip(forces).map(slope).collect()
    };
    let moved = |by: &[[[f64; 2]; 2]], h: f64| -> Vec<Star> {
        let star = |(star, [dx, dv]): (&Star, &[[f64; 2]; 2])| Star {
            x: [star.x[0] + h * dx[0], star.x[1] + h * dx[1]],
            v: [star.v[0] + h * dv[0], star.v[1] + h * dv[1]],
            m: star.m,
        };
        stars.iter().zip(by).map(star).collect()
    };
    let first = slopes(stars);
    let second = slopes(&moved(&first, h / 2.0));
    let third = slopes(&moved(&second, h / 2.0));
    let fourth = slopes(&moved(&third, h));
    let mean = |k: usize, part: usize, axis: usize| {
        let of = |slopes: &[[[f64; 2]; 2]]| slopes[k][part][axis];
        (of(&first) + 2.0 * of(&second) + 2.0 * of(&third) + of(&fourth)) / 6.0
    };
    let means: Vec<_> = (0..stars.len())
        .map(|k| [0, 1].map(|part| [0, 1].map(|axis| mean(k, part, axis))))
        .collect();
    moved(&means, h)
}

fn stepped(scheme: Scheme, i: usize, rate: f64, steps: usize) -> Vec<Star> {
    let (mut world, mut method) = (cluster::<f64>(i), scheme.method());
    let mut pull = law::<f64>().pull();
    let step = Step::hz(ratio(rate)).unwrap();
    (0..steps).for_each(|_| world.step(&mut method, &mut pull, &step));
    stars(&world)
}

/// Largest distance between `a + share (b - a)` and `c`.
fn apart(a: &[Star], b: &[Star], share: f64, c: &[Star]) -> f64 {
    let of = |k: usize, axis: usize| {
        let [a, b, c] = [a, b, c].map(|stars| stars[k].x[axis]);
        (a + share * (b - a) - c).abs()
    };
    let all: Vec<f64> = (0..c.len()).flat_map(|k| [of(k, 0), of(k, 1)]).collect();
    maximum(&all)
}

/// Two seconds. The error of a method of order p is `C h^p`: halving h leaves `2^-p` of it, and what
/// both runs together say, `(2^p x½ - x) / (2^p - 1)`, is off by the next power alone: by h ω of that,
/// or, of Verlet, by its square. Runge-Kutta at 240 Hz is off by (h ω)^4 of a few metres, 4e-11.
fn check_law(scheme: Scheme, order: i32, rest: f64) {
    let (mut halved, mut rests) = (vec![], vec![]);
    for i in 0..16 {
        let [coarse, fine] = [1, 2].map(|k| stepped(scheme, i, RATE * k as f64, 120 * k));
        let mut exact = stars(&cluster::<f64>(i));
        for _ in 0..480 {
            exact = runge_kutta(law::<f64>(), &exact, 1.0 / (4.0 * RATE));
        }
        let error = apart(&coarse, &fine, 0.0, &exact);
        assert!(error > 1e-6, "{scheme:?}: nothing to tell apart");
        halved.push((apart(&coarse, &fine, 1.0, &exact) / error * 2.0_f64.powi(order) - 1.0).abs());
        let share = 2.0_f64.powi(order) / (2.0_f64.powi(order) - 1.0);
        rests.push((apart(&coarse, &fine, share, &exact) - 4e-11).max(0.0) / error);
    }
    within(
        rest,
        &format!("f64 {scheme:?} order, of its error"),
        &halved,
    );
    within(
        rest,
        &format!("f64 {scheme:?} extrapolated, of its error"),
        &rests,
    );
}

#[test]
fn the_law_is_newtons_softened() {
    let part = FASTEST / RATE;
    check_law(Scheme::Verlet, 2, part * part);
    check_law(Scheme::SemiImplicitEuler, 1, part);
}

#[test]
fn energies_are_newtons_softened() {
    for i in 0..16 {
        let (world, law) = (cluster::<f64>(i), law::<f64>());
        let stars = stars(&world);
        let exact: f64 = pairs(N)
            .map(|(a, b)| law.potential(&stars[a], &stars[b]))
            .sum();
        // 28 terms of one sign, a few roundings each.
        let energy = world.potential_energy(&law.pull::<f64>());
        assert!(
            (energy - exact).abs() <= 40.0 * f64::EPSILON * -exact,
            "{energy} {exact}"
        );
    }
}

const TURNS: f64 = 10.0;

/// Two bodies of 1 and 3 kg that circle at 1 rad/s: `ω² = G (m1 + m2) / (d² + ε²)^(3/2)`, where
/// s = 5/4 d. Gives the angle beyond `ω T` after about ten turns.
fn beyond<S: Scale>(i: usize, rate: f64) -> f64 {
    let (d, (sin, cos)) = (S::LENGTH, angle(i).sin_cos());
    let law = Law {
        constant: (1.25 * d).powi(3) / 4.0,
        softening: 0.75 * d,
    };
    let body = |m, r: f64| -> Point<S> { point([r * cos, r * sin], [-r * sin, r * cos], m) };
    let mut world: World<_, 2> = world([body(1.0, -0.75 * d), body(3.0, 0.25 * d)]);
    let (mut pull, mut method) = (law.pull::<S>(), Scheme::Verlet.method());
    let step = Step::<S>::hz(ratio(rate)).unwrap();
    let steps = (TURNS * std::f64::consts::TAU * rate) as u32;
    (0..steps).for_each(|_| world.step(&mut method, &mut pull, &step));
    let along = world.bodies()[1].position().to_f64() - world.bodies()[0].position().to_f64();
    let turned = f64::from(steps) * step.seconds().to_f64();
    let (sin, cos) = (angle(i) + turned).sin_cos();
    (along.y * cos - along.x * sin).atan2(along.x * cos + along.y * sin)
}

/// Verlet runs ahead by a part of (h ω)², which halving h shows; what is left is its square.
#[test]
fn two_bodies_circle_as_the_closed_form_says() {
    let angle = TURNS * std::f64::consts::TAU;
    let errors: [f64; 16] = std::array::from_fn(|i| {
        let [coarse, fine] = [RATE, 2.0 * RATE].map(|rate| beyond::<f64>(i, rate));
        assert!(coarse.abs() > 0.01 * angle / RATE.powi(2));
        ((4.0 * fine - coarse) / 3.0).abs()
    });
    within(angle * RATE.powi(-4), "f64 circle, rad", &errors);
}

/// What rounding adds. An error of a velocity changes ω by up to three times its part of v, for the
/// rest of the run; so `3 ω T sqrt(n/3)` of them at the end, two bodies' errors of variance 1/12 unit²
/// each. A position off by δ is worth a velocity off by ω δ, and has two errors alike a step.
/// Five standard deviations; and a coefficient off by ρ changes ω by ρ/2.
fn check_circle<S: Scale>() {
    let (angle, d) = (TURNS * std::f64::consts::TAU, S::LENGTH);
    let units = S::unit(0.75 * d).powi(2) * (1.0 + 4.0);
    let walk = 3.0 * angle * (angle * RATE / 3.0 * 2.0 / 12.0 * units).sqrt() / d;
    let errors: [f64; 16] =
        std::array::from_fn(|i| (beyond::<S>(i, RATE) - beyond::<f64>(i, RATE)).abs());
    let bound = 5.0 * walk + crate::nbody::pull_error::<S>() * angle;
    within(bound, &format!("{} circle, rad", S::name()), &errors);
}

#[test]
fn two_bodies_circle_alike_in_every_scalar() {
    check_circle::<f32>();
    check_circle::<I16F16>();
    check_circle::<I12F20>();
    check_circle::<I8F24>();
    check_circle::<I20F12>();
}
