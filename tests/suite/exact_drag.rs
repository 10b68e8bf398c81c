//! Drags that are solved exactly, and what rounding leaves of that.
//!
//! `decay` and `share` against numbers of 126 bits; the drags against the closed forms of the motions
//! they solve. Errors are counted in units of the scalar where a state has them; every bound has its
//! derivation beside it. A step does its damping in one part or in two halves, so that bounds are
//! written in parts: x is `k h / m`, `l = 1 - exp(-x/p)` what one of p parts takes.

#[path = "exact_drag/ballistic.rs"]
mod ballistic;
#[path = "exact_drag/dead_zone.rs"]
mod dead_zone;
#[path = "exact_drag/exponential.rs"]
mod exponential;
#[path = "exact_drag/flight.rs"]
mod flight;
#[path = "exact_drag/linear.rs"]
mod linear;
#[path = "exact_drag/memory.rs"]
mod memory;
#[path = "exact_drag/orders.rs"]
mod orders;
#[path = "exact_drag/quadratic.rs"]
mod quadratic;
#[path = "exact_drag/reference.rs"]
mod reference;
#[path = "exact_drag/sequence.rs"]
mod sequence;
#[path = "exact_drag/share.rs"]
mod share;
use crate::support;
#[path = "exact_drag/turns.rs"]
mod turns;

use support::{Format, Scheme};

/// Steps a second.
const RATE: f64 = 60.0;

/// Parts in which a method damps.
fn parts(scheme: Scheme) -> u32 {
    match scheme {
        Scheme::Euler | Scheme::SemiImplicitEuler => 1,
        _ => 2,
    }
}

/// Whether the scalar is a float: its unit at zero is next to nothing.
fn floats<S: Format>() -> bool {
    S::unit(0.0) < 1e-30
}

/// What a coefficient of a drag may be off, relatively. `k`, `h`, two or three products: half an
/// epsilon of the coefficient each; the loss 8 of them and a share 4. With `COEFFICIENT` of 1.5 in
/// fixed point and 3 in floats, 12 are within 8 of it.
fn coefficients<S: Format>() -> f64 {
    8.0 * S::COEFFICIENT
}

/// `from (to/from)^(i/(n-1))`: n values, evenly in their logarithm.
fn grid(from: f64, to: f64, n: usize) -> impl Iterator<Item = f64> {
    (0..n).map(move |i| from * (to / from).powf(i as f64 / (n - 1) as f64))
}
