//! The exact period of a pendulum, at any amplitude.
//!
//! ```text
//! θ'' = -ω0² sin θ        ω0² = m g a / (I + m a²)        3 g / 2 l for a rod hung at its end
//! T = 4 K(sin θ0/2) / ω0 = T0 / agm(1, cos θ0/2)      T0 = 2π / ω0
//! ```
//!
//! Gauss: `K(k) = π / (2 agm(1, √(1 - k²)))`. The arithmetic-geometric mean doubles its digits in every
//! turn of the loop.

use crate::swing::{ARM, FALL, INERTIA, MASS};

/// ω0, rad/s: of swings that are small.
pub fn frequency() -> f64 {
    let [arm, g, inertia, mass] = [ARM, FALL, INERTIA, MASS].map(|value| value.to_f64());
    (-mass * g * arm / (inertia + mass * arm * arm)).sqrt()
}

/// Of a swing by `degrees` to both sides, s.
pub fn period(degrees: f64) -> f64 {
    let half = degrees.to_radians() / 2.0;
    std::f64::consts::TAU / frequency() / mean(1.0, half.cos())
}

/// The arithmetic-geometric mean of positive numbers not farther apart than 1 and 1e-3: there six turns
/// leave less than rounding does.
fn mean(mut a: f64, mut b: f64) -> f64 {
    for _ in 0..6 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    a
}
