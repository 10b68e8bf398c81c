//! Three scenes of sixteen bodies at 60 Hz by semi-implicit Euler, and how far each start is off.

use std::f64::consts::TAU;
use std::fmt::Debug;

use fixstep::scalar::Factor;
use fixstep::{Anchor, Body, Carried, Carry, Point, Ratio, Scalar, SemiImplicitEuler, Step, World};

use super::duffing::{self, Lengths, Setup};
use crate::support::*;

/// Rising numbers of steps.
pub type Counts = [u32];

const SETUP: Setup = Setup {
    scheme: Scheme::SemiImplicitEuler,
    rate: (60, 1),
};

/// A kind of body, and the lengths of time that it drifts by.
pub trait Kind: Body<S: Format> + From<Point<Self::S>> + Debug {
    fn name() -> String;

    fn lengths() -> Lengths;

    /// Of a drift in even and in odd ticks.
    fn drifts() -> [f64; 2];
}

fn h() -> Ratio {
    Ratio::new(1, 60).unwrap()
}

impl<S: Format> Kind for Point<S> {
    fn name() -> String {
        S::name()
    }

    fn lengths() -> Lengths {
        Lengths::point::<S>(&SETUP)
    }

    fn drifts() -> [f64; 2] {
        S::spans(h()).unwrap().map(Factor::to_f64)
    }
}

impl<S: Format + Carry> Kind for Carried<S> {
    fn name() -> String {
        S::name() + " carried"
    }

    fn lengths() -> Lengths {
        Lengths::carried::<S>(&SETUP)
    }

    fn drifts() -> [f64; 2] {
        [S::Coef::new(h()).unwrap().to_f64(); 2]
    }
}

/// The oscillator whose frequency depends on its energy: length of the error in x (m) and v (m/s).
pub fn oscillator<B: Kind>(counts: &Counts) -> Vec<Vec<f64>> {
    let runs = duffing::run::<B>(&SETUP, &B::lengths(), counts);
    runs.iter().map(|errors| errors.state.to_vec()).collect()
}

/// Bodies that pass it are shifted back by as much, remainders and all.
const WRAP: f64 = 64.0;

/// At 0.5 to 3 m/s, to either side: distance flown less `v t`, m.
pub fn cruise<B: Kind>(counts: &Counts) -> Vec<Vec<f64>> {
    let speed = |i: usize| (0.5 + 2.5 * spread(i)) * if i.is_multiple_of(2) { 1.0 } else { -1.0 };
    let body = |i: usize| point([WRAP * spread(i + 17), 0.0], [speed(i), 0.0], 1.0).into();
    let mut world: World<B, 16> = world(std::array::from_fn(body));
    let starts = world.clone();
    let (end, back) = (scalar::<B::S>(WRAP), vector(-WRAP, 0.0));
    let (step, mut laps, mut found) = (Step::hz(60).unwrap(), [0.0; 16], vec![]);
    for n in 1..=last(counts) {
        world.step(&mut SemiImplicitEuler, &mut (), &step);
        for ((_, body), laps) in world.iter_mut().zip(&mut laps) {
            let x = body.position().x;
            if x >= end {
                body.shift(back);
                *laps += WRAP;
            } else if x <= end.negated() {
                body.shift(-back);
                *laps -= WRAP;
            }
        }
        if counts.contains(&n) {
            let bodies = world.bodies().iter().zip(starts.bodies()).zip(&laps);
            let error = |((now, then), laps): ((&B, &B), &f64)| {
                let [to, from] = [now, then].map(|body| body.position().x.to_f64());
                let path = then.velocity().x.to_f64() * f64::from(n) / 60.0;
                (to - from + laps - path).abs()
            };
            found.push(bodies.map(error).collect());
        }
    }
    found
}

/// Springs of 1 m at sixteen frequencies from 0.5 to 2.6 Hz, two starts each, beside the map `v -= κ
/// x, x += h v` in `f64`: length of the error in x and v/ω, m.
pub fn spring<B: Kind>(counts: &Counts) -> Vec<Vec<f64>> {
    let omega = |i: usize| TAU * (0.5 + 2.1 * i as f64 / 15.0);
    let body = |i: usize| {
        let part = |k: usize| [angle(k).cos(), omega(i) * angle(k).sin()];
        let (x, y) = (part(2 * i), part(2 * i + 1));
        point([x[0], y[0]], [x[1], y[1]], 1.0).into()
    };
    let mut world: World<B, 16> = world(std::array::from_fn(body));
    let stiffness: [f64; 16] = std::array::from_fn(|i| omega(i) * omega(i));
    let mut forces: [Anchor<B::S>; 16] = anchors(&world, stiffness);
    let kick = stiffness.map(|k| {
        let [k, h] = [ratio(k), h()].map(|c| <B::S as Scalar>::Coef::new(c).unwrap());
        B::S::product(k, h).to_f64()
    });
    let (step, drifts, mut found) = (Step::hz(60).unwrap(), B::drifts(), vec![]);
    let mut exact = states(&world);
    for n in 1..=last(counts) {
        world.step(&mut SemiImplicitEuler, &mut forces, &step);
        // Ticks count from zero.
        let h = drifts[((n - 1) & 1) as usize];
        for (i, [x, v]) in exact.iter_mut().enumerate() {
            *v -= kick[i / 2] * *x;
            *x += h * *v;
        }
        if counts.contains(&n) {
            let pairs = states(&world).into_iter().zip(exact).enumerate();
            let error = |(i, ([x, v], [to, w])): (usize, ([f64; 2], [f64; 2]))| {
                (x - to).hypot((v - w) / omega(i / 2))
            };
            found.push(pairs.map(error).collect());
        }
    }
    found
}

/// Positions and velocities along both axes of each body.
fn states<B: Body>(world: &World<B, 16>) -> [[f64; 2]; 32] {
    std::array::from_fn(|i| {
        let body = &world.bodies()[i / 2];
        [body.position(), body.velocity()].map(|pair| pair.to_f64().array()[i % 2])
    })
}

fn last(counts: &Counts) -> u32 {
    counts.last().copied().unwrap_or(0)
}
