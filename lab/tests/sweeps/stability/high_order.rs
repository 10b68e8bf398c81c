//! Closed forms of the methods of order 4, as those of `law.rs`.

use super::{Drag, Law};
use crate::support::Scheme;

pub const RK4: Law = Law {
    scheme: Scheme::Rk4,
    calls: 4,
    spring: rk4,
    linear: |g| taylor(-g),
    quadratic: rk4_quadratic,
};

pub const PEFRL: Law = Law {
    scheme: Scheme::Pefrl,
    calls: 4,
    spring: pefrl,
    linear: |g| KICKS.iter().map(|kick| 1.0 - kick * g).product(),
    quadratic: |a| {
        KICKS
            .iter()
            .fold(1.0_f64, |v, kick| v - kick * a * v * v.abs())
    },
};

/// `exp(z)` up to `z^4`: what a step of order 4 with four calls makes of `x' = z x`.
fn taylor(z: f64) -> f64 {
    1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)))
}

/// A step is the same polynomial of the matrix `A = ((0, q), (-q, -g))` of the motion itself. As `A² =
/// -g A - q²`, it is some `a + b A`, of trace `2 a - g b` and determinant `a² - g a b + q² b²`.
/// Multiplied by A that is `-q² b + (a - g b) A`.
///
/// Exact drag in two halves goes round a step without drag, `((a, q b), (-q b, a))`: trace `a (1 +
/// s²)`, det `s² (a² + q² b²)`.
///
/// Undamped `a² + q² b² = 1 - q^6/72 + q^8/576`: stable for `q² <= 8`.
fn rk4(drag: Drag, q: f64, zeta: f64) -> [f64; 2] {
    let g = match drag {
        Drag::Explicit => 2.0 * zeta * q,
        Drag::Exact => 0.0,
    };
    let (mut a, mut b) = (1.0, 0.0);
    for n in [4.0, 3.0, 2.0, 1.0] {
        (a, b) = (1.0 - q * q * b / n, (a - g * b) / n);
    }
    match drag {
        Drag::Explicit => [2.0 * a - g * b, a * a - g * a * b + q * q * b * b],
        Drag::Exact => {
            let d = (-2.0 * zeta * q).exp();
            [a * (1.0 + d), d * (a * a + q * q * b * b)]
        }
    }
}

/// The four stages, each of a velocity by that of the start.
fn rk4_quadratic(a: f64) -> f64 {
    let kick = |v: f64| -a * v * v.abs();
    let k1 = kick(1.0);
    let k2 = kick(1.0 + k1 / 2.0);
    let k3 = kick(1.0 + k2 / 2.0);
    let k4 = kick(1.0 + k3);
    1.0 + (k1 + 2.0 * k2 + 2.0 * k3 + k4) / 6.0
}

/// What each kick takes of a step, and each drift: Omelyan, Mryglod, Folk (2002), Eq. 22.
const KICKS: [f64; 4] = [0.5 - LAMBDA, LAMBDA, LAMBDA, 0.5 - LAMBDA];
const DRIFTS: [f64; 5] = [XI, CHI, 1.0 - 2.0 * (CHI + XI), CHI, XI];
const XI: f64 = 0.178_617_895_844_809_1;
const LAMBDA: f64 = -0.212_341_831_062_605_4;
const CHI: f64 = -0.066_264_582_669_818_5;

/// Nine shears: `x += t q u` and `u -= c (q x + g u)`, multiplied out in numbers; its limits have no
/// form that is shorter. The determinant is that of the kicks, and of exact drag. Exact drag goes round
/// all.
fn pefrl(drag: Drag, q: f64, zeta: f64) -> [f64; 2] {
    let (g, s) = match drag {
        Drag::Explicit => (2.0 * zeta * q, 1.0),
        Drag::Exact => (0.0, (-zeta * q).exp()),
    };
    let columns = [[1.0, 0.0], [0.0, s]].map(|[mut x, mut u]| {
        for (drift, kick) in DRIFTS.into_iter().zip(KICKS.into_iter().chain([0.0])) {
            x += drift * q * u;
            u -= kick * (q * x + g * u);
        }
        [x, s * u]
    });
    let det = KICKS.iter().map(|kick| 1.0 - kick * g).product::<f64>() * s * s;
    [columns[0][0] + columns[1][1], det]
}
