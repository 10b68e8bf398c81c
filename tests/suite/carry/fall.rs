//! A minute of free fall, and of random pushes: beside the exact solution a body that carries is nearer
//! than a point.

use fixstep::fixed::types::{I8F24, I12F20, I16F16};
use fixstep::{Body, Carried, GravityY, PerBody, Point, Scalar, Step, Time, Vec2, Verlet, World};

use super::bits::Fine;
use crate::support::*;

const STEPS: u32 = if LAB { 3600 } else { 600 };

/// A fall from 0.9 of the range to its middle, from sixteen starts: errors in m at the end beside
/// `v t + g t²/2`.
fn fall<B: Body<S: Format> + From<Point<B::S>> + std::fmt::Debug>(g: f64) -> [f64; 16] {
    let height = 0.9 * B::S::MAX.to_f64();
    let start = |i: usize| {
        let speed = [0.3 + spread(i), spread(i + 16) - 0.5];
        point::<B::S>([0.0, height * (0.9 + 0.1 * spread(i))], speed, 1.0).into()
    };
    let mut world: World<B, 16> = world(std::array::from_fn(start));
    let starts = world.clone();
    let mut gravity = GravityY::new(ratio(-g)).unwrap();
    for _ in 0..STEPS {
        world.step(&mut Verlet, &mut gravity, &Step::hz(60).unwrap());
    }
    // Gravity is what the scalar holds of it.
    let (t, g) = (STEPS as f64 / 60.0, scalar::<B::S>(-g).to_f64());
    std::array::from_fn(|i| {
        let (now, then) = (&world.bodies()[i], &starts.bodies()[i]);
        let [to, from, v] = [now.position(), then.position(), then.velocity()].map(Vec2::to_f64);
        let [x, y] = [from.x + v.x * t, from.y + v.y * t + g * t * t / 2.0];
        (to.x - x).hypot(to.y - y)
    })
}

/// Both see x to half a unit. v is the sum of gains rounded once, off by half a unit at most: over 60 s,
/// if always the same way, 30 units. A point rounds twice a step.
fn check_fall<S: Fine>() {
    let (unit, height) = (S::unit(0.0), 0.8 * S::MAX.to_f64());
    let g = (height / 1800.0).min(9.81);
    let (carried, plain) = (fall::<Carried<S>>(g), fall::<Point<S>>(g));
    let name = S::name();
    let h = 2.0_f64.powi(-30) * 2.0 * height;
    within(
        31.0 * unit + h,
        &format!("{name} carried falls 60 s, m"),
        &carried,
    );
    let rounded = STEPS as f64 * unit;
    within(
        31.0 * unit + h + rounded,
        &format!("{name} Point falls 60 s, m"),
        &plain,
    );
    assert!(2.0 * median(&carried) <= median(&plain), "{name}");
    assert!(maximum(&carried) <= maximum(&plain), "{name}");
}

#[test]
fn a_fall_is_nearer_to_the_exact_one() {
    check_fall::<I16F16>();
    check_fall::<I12F20>();
    check_fall::<I8F24>();
}

/// Gusts of up to 1 N, whole multiples of 1/256 N, so that every scalar has the same.
fn gust<S: Scalar>(seed: usize, tick: u64) -> Vec2<S> {
    let mut random = Random(tick << 8 | seed as u64);
    let mut part = || (random.next() >> 55) as f64 / 256.0 - 1.0;
    let (x, y) = (part(), part());
    vector(x, y)
}

/// Positions after a minute of gusts, of sixteen bodies of 2 kg, by Verlet.
fn blown<B: Body<S: Format> + From<Point<B::S>> + std::fmt::Debug>() -> [Vec2<f64>; 16] {
    std::array::from_fn(|i| {
        let mut world: World<B, 1> = world([point::<B::S>([0.0; 2], [0.25, -0.5], 2.0).into()]);
        let mut forces = PerBody(move |time: Time, _: &B| gust(i, time.half_ticks()));
        for _ in 0..STEPS {
            world.step(&mut Verlet, &mut forces, &Step::hz(60).unwrap());
        }
        world.bodies()[0].position().to_f64()
    })
}

/// `f64` makes the same map to 1e-13 m. A body that carries keeps v to `2^-15` units, of which rounding
/// is a random walk over 3600 kicks, and drifts by v as it is seen: half a unit off, 60 s long at worst.
fn check_gusts<S: Fine>() {
    let (exact, unit) = (blown::<Point<f64>>(), S::unit(0.0));
    let errors = |places: [Vec2<f64>; 16]| -> [f64; 16] {
        std::array::from_fn(|i| (places[i] - exact[i]).length())
    };
    let (carried, plain) = (errors(blown::<Carried<S>>()), errors(blown::<Point<S>>()));
    let name = S::name();
    // On either axis; h is off by 2^-31 of a path below 64 m.
    let bound = 1.5 * (30.5 * unit + 64.0 * 2.0_f64.powi(-29));
    within(bound, &format!("{name} carried in gusts 60 s, m"), &carried);
    // A point's v walks by half a unit a kick: over 60 s, all one way.
    let bound = STEPS as f64 * unit * 60.0;
    within(bound, &format!("{name} Point in gusts 60 s, m"), &plain);
    assert!(4.0 * median(&carried) <= median(&plain), "{name}");
    assert!(maximum(&carried) <= median(&plain), "{name}");
}

#[test]
fn a_body_in_gusts_is_nearer_to_the_exact_one() {
    check_gusts::<I16F16>();
    check_gusts::<I12F20>();
    check_gusts::<I8F24>();
}
