//! What rounding should do to an orbit, derived.
//!
//! A rounding moves x by δx or v by δv, evenly spread over a unit u: its variance is u²/12. The energy
//! walks by `v δv - a δx`, so after N steps its variance is N times the mean q of
//!
//! ```text
//! q = v² σv² + a² σx²
//! ```
//!
//! over an orbit. With the energy the frequency ω is off, and what is off adds up:
//!
//! ```text
//! σ(energy) = sqrt(q N)         σ(time ahead) = h ω'/ω sqrt(q N³ / 3)
//! ```
//!
//! the powers 1/2 and 3/2 of Brouwer, "On the accumulation of errors in numerical integration", Astron.
//! J. 46 (1937). What moves the phase at once, a power 1/2, is left out: it is a tenth at 10³ steps.
//!
//! **A point** rounds v in each kick and x in each drift. Verlet drifts by half a step before a kick and
//! after it; two halves between two kicks have one velocity, so that both round the same way, and count
//! as one of twice the size. The force is off by a few units too, but that counts h times.
//!
//! **A body that keeps remainders** rounds what is seen. A drift sees v, and a kick sees x, with the
//! slope of the force, `1 + 3 x²`; the force rounds x² (times x), x³, and in floats the sum. All of
//! that counts h times. A float also rounds each product and, with the rest of the last sum, the term
//! to be added: twice a unit of `h v` and of `h a`, which fixed point has exactly but for 2^-15.

use crate::rounding::duffing::{
    Lengths, STARTS, Setup, State, acceleration, energy, frequency, start,
};
use crate::support::Format;

/// Variances of x and of v that a step adds at a state.
pub type Noise = fn(&Setup, State) -> [f64; 2];

fn square(x: f64) -> f64 {
    x * x
}

/// The variance of one rounding of a number.
fn rounding<S: Format>(at: f64) -> f64 {
    square(S::unit(at)) / 12.0
}

pub fn point<S: Format>(setup: &Setup, [x, v]: State) -> [f64; 2] {
    let moved = square(setup.scheme.drifts()) * rounding::<S>(x);
    [moved, rounding::<S>(v)]
}

pub fn carried<S: Format>(setup: &Setup, [x, v]: State) -> [f64; 2] {
    let (h, a) = (setup.seconds(), acceleration(x));
    let slope = 1.0 + 3.0 * x * x;
    let products = square(x) * rounding::<S>(x * x) + rounding::<S>(x * x * x);
    let seen = [
        rounding::<S>(v),
        square(slope) * rounding::<S>(x) + products,
    ];
    let floats = S::unit(1.0) != S::unit(0.0);
    let [moved, kicked] = seen.map(|variance| h * h * variance);
    if floats {
        let drift = 2.0 * rounding::<S>(h * v);
        let kick = 2.0 * rounding::<S>(h * a) + h * h * rounding::<S>(a);
        return [moved + drift, kicked + kick];
    }
    [moved, kicked]
}

/// For each start: q, and the share of a second that a joule runs ahead in a second.
#[derive(Clone, Debug)]
pub struct Law {
    h: f64,
    walk: [f64; STARTS],
    shear: [f64; STARTS],
}

impl Law {
    /// The mean over 8192 steps, thirty periods or more.
    pub fn new(setup: &Setup, lengths: &Lengths, noise: Noise) -> Law {
        const STEPS: u32 = 8192;
        let walk = |i| {
            let of = |[x, v]: State| {
                let [sx, sv] = noise(setup, [x, v]);
                square(v) * sv + square(acceleration(x)) * sx
            };
            let sum: f64 = lengths.orbit(setup.scheme, i, STEPS).map(of).sum();
            sum / f64::from(STEPS)
        };
        let shear = |i| {
            const APART: f64 = 1e-4;
            let [below, at, above] = [-APART, 0.0, APART].map(|d| frequency(energy(start(i)) + d));
            (above - below) / (2.0 * APART) / at
        };
        Law {
            h: setup.seconds(),
            walk: std::array::from_fn(walk),
            shear: std::array::from_fn(shear),
        }
    }

    /// One standard deviation of the energy after n steps.
    pub fn energy(&self, i: usize, n: u32) -> f64 {
        (self.walk[i] * f64::from(n)).sqrt()
    }

    /// One standard deviation of the time ahead after n steps.
    pub fn ahead(&self, i: usize, n: u32) -> f64 {
        let cube = f64::from(n).powi(3);
        self.h * self.shear[i] * (self.walk[i] * cube / 3.0).sqrt()
    }
}
