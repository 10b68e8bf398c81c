//! Five bodies that pull each other, 10^5 steps out and 10^5 back.

use fixstep::fixed::types::{I8F24, I16F16, I32F32};
use fixstep::{AllPairs, Pefrl, Pull, Vec2};

use super::*;
use crate::support::{Format, Random, point, ratio};

/// A heavy body and four light ones on softened orbits round it; `start` chooses where, how fast and
/// which way. Momentum is zero but for rounding, so the scene stays near the origin.
pub fn bodies<S: Scalar>(start: u64) -> [Point<S>; 5] {
    let mut random = Random(start);
    let mut between = |low: f64, high: f64| {
        low + (high - low) * (random.next() >> 11) as f64 / (1_u64 << 53) as f64
    };
    let mut momentum = Vec2::new(0.0, 0.0);
    let light: Vec<Point<S>> = (0..4)
        .map(|i| {
            let radius = 2.0 + 1.1 * i as f64 + between(-0.2, 0.2);
            let (sin, cos) = between(0.0, std::f64::consts::TAU).sin_cos();
            // Round a softened G M of 10 m³/s², up to a fifth off the circular speed, some the other way.
            let speed = between(0.8, 1.15) * (10.0 * radius * radius).sqrt()
                / (radius * radius + 0.25).powf(0.75);
            let speed = if between(0.0, 1.0) < 0.25 {
                -speed
            } else {
                speed
            };
            let mass = between(0.1, 0.9);
            let velocity = [-speed * sin, speed * cos];
            momentum.x += mass * velocity[0];
            momentum.y += mass * velocity[1];
            point([radius * cos, radius * sin], velocity, mass)
        })
        .collect();
    let heavy = point([0.0, 0.0], [-momentum.x / 50.0, -momentum.y / 50.0], 50.0);
    [heavy, light[0], light[1], light[2], light[3]]
}

pub fn pull<S: Scalar>() -> AllPairs<Pull<S>> {
    AllPairs(Pull::new(ratio(0.2), ratio(0.5)).unwrap())
}

fn returns<S: Format + fixstep::Exact>(
    way: &str,
    start: u64,
    mut method: impl Rewinds<RangeChecked<Point<S>>, 5>,
    step: &impl TimeStep<S>,
    length: [u64; 2],
) {
    let name = format!("{}, {way}", S::name());
    let mut world = watched(bodies(start));
    there_and_back(&name, &mut world, &mut method, &mut pull(), step, length);
}

fn long<S: Format + fixstep::Exact>(
    way: &str,
    start: u64,
    method: impl Rewinds<RangeChecked<Point<S>>, 5>,
    step: &impl TimeStep<S>,
) {
    returns(
        way,
        start,
        method,
        step,
        [support::long(100_000), support::long(1000)],
    );
}

fn short<S: Format + fixstep::Exact>(
    way: &str,
    start: u64,
    method: impl Rewinds<RangeChecked<Point<S>>, 5>,
    step: &impl TimeStep<S>,
) {
    returns(
        way,
        start,
        method,
        step,
        [support::long(10_000), support::long(100)],
    );
}

#[test]
fn i16f16_returns() {
    every_way!(long::<I16F16>, 1);
    every_way!(long::<I16F16>, 13);
}

#[test]
fn i8f24_returns() {
    every_way!(long::<I8F24>, 5);
    every_way!(long::<I8F24>, 9);
}

#[test]
fn i32f32_returns() {
    every_way!(short::<I32F32>, 17);
}

#[test]
fn pefrl_returns() {
    fn both<S: Format + fixstep::Exact>(start: u64) {
        let (hz, dyadic) = (
            Step::<S>::hz(60).unwrap(),
            DyadicStep::<S, 1, 6>::new().unwrap(),
        );
        short("Pefrl, 1/60", start, Pefrl::new(), &hz);
        short("Pefrl, 1/64", start + 1, Pefrl::new(), &dyadic);
    }
    both::<I16F16>(21);
    both::<I8F24>(23);
}
