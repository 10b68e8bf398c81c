//! What the step does to the period of a pendulum, from the energy that the method follows.
//!
//! A quarter of the swing is `sin(θ/2) = k sin φ`, φ from 0 to π/2, with `k = sin(θ0/2)`:
//!
//! ```text
//! dt = dφ / √(1 - k² s²)      p² = 4 k² c²      V'² = 4 k² s² (1 - k² s²)      V'' = 1 - 2 k² s²
//! ```
//!
//! with s and c the sine and cosine of φ. The action of an orbit of modified energy E is that of the pendulum
//! less `h² a(E)`, `a = ∮ A dt`; its period is the derivative, `T(E) - h² a'(E)`. A release at rest has
//! `E = V + h² V'²/12 = 2k² - 1 + h² k² (1 - k²) / 3`, and `dE = 4 k dk`.

use std::f64::consts::FRAC_PI_2;

use crate::exact;

/// `(T' - T) / T` as a multiple of `(h ω0)²`.
pub fn stretch(degrees: f64) -> f64 {
    let k = (degrees.to_radians() / 2.0).sin();
    let per_energy = |f: fn(f64) -> f64| (f(k + STEP) - f(k - STEP)) / (2.0 * STEP) / (4.0 * k);
    let lift = k * k * (1.0 - k * k) / 3.0;
    (per_energy(period) * lift - per_energy(action)) / period(k)
}

/// `d(ln T) / d(ln E)`, with E from the lowest point: `2 k²`.
pub fn softening(degrees: f64) -> f64 {
    let k = (degrees.to_radians() / 2.0).sin();
    let at = |k: f64| exact::period(2.0 * k.asin().to_degrees()).ln();
    (at(k + STEP) - at(k - STEP)) / (2.0 * STEP) * k / 2.0
}

/// Of a derivative by k, which it leaves with an error below 1e-6: 150° are k = 0.966.
const STEP: f64 = 1e-5;

/// T in units of `1/ω0`.
fn period(k: f64) -> f64 {
    round(k, |_, _| 1.0)
}

/// `∮ A dt`.
fn action(k: f64) -> f64 {
    round(k, |s2, c2| {
        let (p2, slope2) = (4.0 * k * k * c2, 4.0 * k * k * s2 * (1.0 - k * k * s2));
        slope2 / 12.0 - p2 * (1.0 - 2.0 * k * k * s2) / 24.0
    })
}

/// `∮ f dt`, with the squares of s and c. The integrand has the period π, so that middles of equal parts
/// converge like a power: to rounding with 200.
fn round(k: f64, f: impl Fn(f64, f64) -> f64) -> f64 {
    const PARTS: u32 = 200;
    let part = |i| {
        let (s, c) = (FRAC_PI_2 * (f64::from(i) + 0.5) / f64::from(PARTS)).sin_cos();
        f(s * s, c * c) / (1.0 - k * k * s * s).sqrt()
    };
    4.0 * FRAC_PI_2 / f64::from(PARTS) * (0..PARTS).map(part).sum::<f64>()
}
