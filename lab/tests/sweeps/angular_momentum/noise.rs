//! What roundings change of the momenta of a pair in a step. Each is an error of variance 1/12 of a unit² of its
//! own, u:
//!
//! ```text
//! J     each part, along d     |d| u         the impulse is not quite along the line
//! v     each part              m |x| u       J / m; of P, m u
//! s     once                   2πI u         r×J / 2πI
//! x     each part, twice       m |v| u       h/2 v before and behind a kick, which round alike
//! ```

use std::f64::consts::TAU;

use fixstep::rigid::Centre;
use fixstep::{Angular, Carried, CarryAngular, Point, Rotating, Scalar, World};

use super::{INERTIAS, MASSES, RATE, STIFFNESS};
use crate::support::*;

/// How far from its centre of mass a body holds the spring, m.
const ARM: f64 = 0.5;

/// The largest of what errors are multiplied by, in a run.
#[derive(Clone, Copy, Default)]
pub struct Sizes {
    place: [f64; 2],
    speed: [f64; 2],
    spin: [f64; 2],
    line: f64,
    impulse: f64,
}

impl Sizes {
    /// Seen at the end of a step; a 60th of a second at these speeds is a part in 30 of a length.
    pub fn see<B: Rotating>(&mut self, world: &World<B, 2>) {
        let [a, b] = [0, 1].map(|k| &world.bodies()[k]);
        for (k, body) in [a, b].into_iter().enumerate() {
            let (x, v) = (body.position().to_f64(), body.velocity().to_f64());
            self.place[k] = maximum(&[self.place[k], x.length()]);
            self.speed[k] = maximum(&[self.speed[k], v.length()]);
            self.spin[k] = maximum(&[self.spin[k], body.turns_per_second().to_f64().abs()]);
        }
        let apart = (b.position() - a.position()).to_f64().length();
        self.line = maximum(&[self.line, apart + 2.0 * ARM]);
        self.impulse = STIFFNESS / RATE * self.line;
    }
}

/// A kind of body in a number type: what a step may change, root mean square.
pub trait Kind: Centre<S: Format> + From<Point<Self::S>> + std::fmt::Debug {
    fn angular(sizes: &Sizes) -> f64;
    fn linear(sizes: &Sizes) -> f64;
    /// What the momentum that is seen may be off by at any time: linear, and angular.
    fn unseen(sizes: &Sizes) -> [f64; 2];
    fn name() -> String;
}

fn root(squares: &[f64]) -> f64 {
    (squares.iter().map(|a| a * a).sum::<f64>() / 12.0).sqrt()
}

/// In floats the product `r×J` has three roundings more, and `d`, a difference of places, is off by a unit of each:
/// it turns J by as much over its length.
impl<S: Format + Angular> Kind for Point<S> {
    fn angular(sizes: &Sizes) -> f64 {
        let floats = S::unit(1.0) != S::unit(1e3);
        let mut all = vec![sizes.line * S::unit(sizes.impulse)];
        for k in 0..2 {
            let (x, v) = (sizes.place[k], sizes.speed[k]);
            all.push(MASSES[k] * x * S::unit(v));
            all.push(TAU * INERTIAS[k] * S::unit(sizes.spin[k]));
            all.push(2.0 * MASSES[k] * v * S::unit(x));
            if floats {
                all.push(2.0 * ARM * S::unit(sizes.impulse));
                all.push(2.0 * sizes.impulse * S::unit(x));
            }
        }
        root(&all)
    }

    fn linear(sizes: &Sizes) -> f64 {
        root(&[0, 1].map(|k| MASSES[k] * S::unit(sizes.speed[k])))
    }

    fn unseen(_: &Sizes) -> [f64; 2] {
        [0.0; 2]
    }

    fn name() -> String {
        S::name() + " Point"
    }
}

/// Nothing is lost of x, v and s but 2^-15 of a unit. The impulse is rounded as ever, and acts along a line between
/// places that are seen rounded. So is what is read: half a unit of each.
impl<S: Format + CarryAngular> Kind for Carried<S> {
    fn angular(sizes: &Sizes) -> f64 {
        let unit = S::unit(0.0);
        let seen = 2.0_f64.sqrt() * sizes.impulse * unit;
        let lost = 2e-4 * Point::<S>::angular(sizes);
        root(&[sizes.line * unit, seen, lost])
    }

    fn linear(_: &Sizes) -> f64 {
        0.0
    }

    fn unseen(sizes: &Sizes) -> [f64; 2] {
        let half = 0.5 * S::unit(0.0);
        let of = |k: usize| 1.5 * MASSES[k] * (sizes.place[k] + sizes.speed[k]) * half;
        [half * (MASSES[0] + MASSES[1]), of(0) + of(1)]
    }

    fn name() -> String {
        S::name() + " Carried"
    }
}
