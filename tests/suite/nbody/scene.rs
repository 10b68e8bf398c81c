//! Softened gravitation written out in `f64`, and eight bodies that it holds together.

use std::f64::consts::TAU;

use fixstep::fixed::types::{I8F24, I12F20, I16F16, I20F12};
use fixstep::scalar::Factor;
use fixstep::{AllPairs, Body, Point, Pull, Scalar, World};

use crate::support::{Format, point, ratio, spread, world};

pub const N: usize = 8;

/// Steps a second.
pub const RATE: f64 = 60.0;

/// A scalar and the size of a scene that suits it, m: far above its unit, far below its range.
pub trait Scale: Format {
    const LENGTH: f64;

    /// Long runs that can be afforded: the square root of a float is made by software.
    const STARTS: usize;
}

macro_rules! scale {
    ($($scalar:ty: $length:literal, $starts:literal;)*) => {$(
        impl Scale for $scalar {
            const LENGTH: f64 = $length;
            const STARTS: usize = $starts;
        }
    )*};
}

scale! {
    f32: 2.0, 4;
    f64: 2.0, 4;
    I16F16: 100.0, 8;
    I12F20: 10.0, 8;
    I8F24: 2.0, 8;
    I20F12: 1000.0, 8;
}

/// A body in `f64`.
#[derive(Clone, Copy, Debug)]
pub struct Star {
    pub x: [f64; 2],
    pub v: [f64; 2],
    pub m: f64,
}

/// The bodies as they are; a mass is the one that the body really has.
pub fn stars<S: Scalar, const M: usize>(world: &World<Point<S>, M>) -> Vec<Star> {
    let star = |body: &Point<S>| Star {
        x: body.position().to_f64().array(),
        v: body.velocity().to_f64().array(),
        m: 1.0 / Factor::<S>::to_f64(body.inv_mass()),
    };
    world.bodies().iter().map(star).collect()
}

pub fn minus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

pub fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// Newton's law with `d² + ε²` for the square of the distance.
#[derive(Clone, Copy, Debug)]
pub struct Law {
    pub constant: f64,
    pub softening: f64,
}

impl Law {
    /// `G m1 m2 d / s³` on the first body.
    pub fn force(self, a: &Star, b: &Star) -> [f64; 2] {
        let d = minus(b.x, a.x);
        let s = (dot(d, d) + self.softening.powi(2)).sqrt();
        d.map(|d| self.constant * a.m * b.m * d / s.powi(3))
    }

    /// `-G m1 m2 / s`
    pub fn potential(self, a: &Star, b: &Star) -> f64 {
        let d = minus(b.x, a.x);
        -self.constant * a.m * b.m / (dot(d, d) + self.softening.powi(2)).sqrt()
    }

    /// How the potential bends along the motion: `u·U″u`, u the difference of velocities.
    pub fn bend(self, a: &Star, b: &Star) -> f64 {
        let (d, u) = (minus(b.x, a.x), minus(b.v, a.v));
        let s = (dot(d, d) + self.softening.powi(2)).sqrt();
        let bent = dot(u, u) / s.powi(3) - 3.0 * dot(d, u).powi(2) / s.powi(5);
        self.constant * a.m * b.m * bent
    }

    /// The force on each body, by all others.
    pub fn forces(self, stars: &[Star]) -> Vec<[f64; 2]> {
        let mut forces = vec![[0.0; 2]; stars.len()];
        for (i, j) in pairs(stars.len()) {
            let [x, y] = self.force(&stars[i], &stars[j]);
            forces[i] = [forces[i][0] + x, forces[i][1] + y];
            forces[j] = [forces[j][0] - x, forces[j][1] - y];
        }
        forces
    }

    pub fn pull<S: Scalar>(self) -> AllPairs<Pull<S>> {
        AllPairs(Pull::new(ratio(self.constant), ratio(self.softening)).unwrap())
    }
}

/// Every two of `count`.
pub fn pairs(count: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..count).flat_map(move |i| (i + 1..count).map(move |j| (i, j)))
}

/// What all bodies in one place would oscillate at, `sqrt(G M / ε³)`, rad/s, whatever the size of the
/// scene: nothing is faster.
pub const FASTEST: f64 = 0.5;

fn mass(k: usize) -> f64 {
    1.0 + 0.13 * k as f64
}

/// Softened so much that no body is thrown out, ε = 2 L. Twenty-four bits of G are exact in every
/// scalar's coefficient.
pub fn law<S: Scale>() -> Law {
    let total: f64 = (0..N).map(mass).sum();
    let softening = 2.0 * S::LENGTH;
    Law {
        constant: f64::from((FASTEST.powi(2) * softening.powi(3) / total) as f32),
        softening,
    }
}

/// Start `i`: eight bodies on a rough ring, turning too slowly to stay on it, centre of mass at rest.
pub fn cluster<S: Scale>(i: usize) -> World<Point<S>, N> {
    let (length, speed) = (S::LENGTH, FASTEST * S::LENGTH);
    let mut stars: [Star; N] = std::array::from_fn(|k| {
        let random = |n: usize| spread(i * 64 + n * N + k);
        let (sin, cos) = (TAU * (k as f64 + 0.6 * random(0)) / N as f64).sin_cos();
        let (r, turn) = (0.5 + random(1), 0.4 + 0.4 * random(2));
        Star {
            x: [length * r * cos, length * r * sin],
            v: [-speed * r * turn * sin, speed * r * turn * cos],
            m: mass(k),
        }
    });
    let total: f64 = stars.iter().map(|star| star.m).sum();
    let mean = [0, 1].map(|axis| stars.iter().map(|s| s.m * s.v[axis]).sum::<f64>() / total);
    stars
        .iter_mut()
        .for_each(|star| star.v = minus(star.v, mean));
    world(stars.map(|star| point(star.x, star.v, star.m)))
}
