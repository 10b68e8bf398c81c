//! Closed forms: one step of each method for a damped spring, as trace and determinant.
//!
//! The state is (x, u) with u = v/ω, q = ω h, and ζ the damping ratio. A step is a product of
//!
//! ```text
//! D(t)  x += t q u            a drift through the part t of a step
//! K     u -= q x + g u        a kick, with explicit drag g = 2 ζ q, with exact drag g = 0
//! E     u *= s                exact drag through half a step, s = exp(-ζ q);  d = s²: a whole one
//! ```
//!
//! and its eigenvalues lie within the unit circle where `|trace| <= 1 + det` and `det <= 1` (Jury).
//! What these two say of q and ζ stands above each method.

#[path = "high_order.rs"]
mod high_order;

use crate::support::Scheme;

/// How the spring is damped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Drag {
    /// As a force that the kick takes from the velocity it sees.
    Explicit,
    /// As a factor beside the kick.
    Exact,
}

pub const DRAGS: [Drag; 2] = [Drag::Explicit, Drag::Exact];

/// A method and what it does in one step.
pub struct Law {
    pub scheme: Scheme,
    /// Force calls in a step.
    pub calls: i32,
    /// Trace and determinant of a step, of q and ζ.
    pub spring: fn(Drag, f64, f64) -> [f64; 2],
    /// `v'/v` under linear drag as a force alone, of `k h / m`.
    pub linear: fn(f64) -> f64,
    /// `v'/v` under quadratic drag as a force alone, of `h c |v| / m`.
    pub quadratic: fn(f64) -> f64,
}

/// One line for each method.
pub const LAWS: [Law; 6] = [
    Law::kicked_once(Scheme::Euler, euler),
    Law::kicked_once(Scheme::ConstantAcceleration, constant_acceleration),
    Law::kicked_once(Scheme::SemiImplicitEuler, semi_implicit),
    Law::kicked_once(Scheme::Verlet, verlet),
    high_order::RK4,
    high_order::PEFRL,
];

impl Law {
    /// One kick a step: drag alone takes from v what it is at the start.
    const fn kicked_once(scheme: Scheme, spring: fn(Drag, f64, f64) -> [f64; 2]) -> Law {
        let once = |rate: f64| 1.0 - rate;
        Law {
            scheme,
            calls: 1,
            spring,
            linear: once,
            quadratic: once,
        }
    }

    /// Where the spring first leaves stability as q rises, to rounding; infinite where it does not up
    /// to 6.
    pub fn limit(&self, drag: Drag, zeta: f64) -> f64 {
        first_root(|q| stable((self.spring)(drag, q, zeta)), 6.0)
    }
}

/// Within the unit circle, on it included.
pub fn stable([trace, det]: [f64; 2]) -> bool {
    trace.abs() <= 1.0 + det && det <= 1.0
}

/// The larger magnitude of the two eigenvalues.
pub fn radius([trace, det]: [f64; 2]) -> f64 {
    let square = trace * trace / 4.0 - det;
    if square < 0.0 {
        det.sqrt()
    } else {
        trace.abs() / 2.0 + square.sqrt()
    }
}

/// Where `holds` first ends between 0 and `end`, infinite where it does not: in steps of 1/1000,
/// halved.
pub fn first_root(holds: impl Fn(f64) -> bool, end: f64) -> f64 {
    let steps = (end * 1000.0) as u32;
    let Some(failing) = (1..=steps).find(|&i| !holds(f64::from(i) / 1000.0)) else {
        return f64::INFINITY;
    };
    let (mut low, mut high) = (f64::from(failing - 1) / 1000.0, f64::from(failing) / 1000.0);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        (low, high) = if holds(middle) {
            (middle, high)
        } else {
            (low, middle)
        };
    }
    high
}

/// Drift and kick see the same state.
///
/// ```text
/// explicit  x' = x + q u, u' = u - q x - g u         trace 2 - g, det 1 - g + q²
///           det: q <= 2 ζ; trace: q² - 4 ζ q + 4 >= 0, so that above ζ = 1 q <= 2 (ζ - sqrt(ζ² - 1))
/// exact     x' = x + q u, u' = d (u - q x)           trace 1 + d, det d (1 + q²)
///           det: q² <= exp(2 ζ q) - 1; trace: always
/// ```
fn euler(drag: Drag, q: f64, zeta: f64) -> [f64; 2] {
    let (g, d) = (2.0 * zeta * q, (-2.0 * zeta * q).exp());
    match drag {
        Drag::Explicit => [2.0 - g, 1.0 - g + q * q],
        Drag::Exact => [1.0 + d, d * (1.0 + q * q)],
    }
}

/// Half drifts with the old and the new velocity, a kick that sees the start, and half of an exact drag
/// before and half after the kick: `x' = x + q/2 (u + u')`.
///
/// ```text
/// explicit  u' = u - q x - g u       trace 2 - g - q²/2, det 1 - g + q²/2
///           det: q <= 4 ζ; trace: g <= 2, so q <= 1/ζ
/// exact     u' = s² u - s q x        trace 1 + s² - s q²/2, det s² + s q²/2
///           det: q² <= 2 (1/s - s) = 4 sinh(ζ q); trace: always
/// ```
fn constant_acceleration(drag: Drag, q: f64, zeta: f64) -> [f64; 2] {
    let (g, s, half) = (2.0 * zeta * q, (-zeta * q).exp(), q * q / 2.0);
    match drag {
        Drag::Explicit => [2.0 - g - half, 1.0 - g + half],
        Drag::Exact => [1.0 + s * s - s * half, s * s + s * half],
    }
}

/// Kick, exact drag, drift.
///
/// ```text
/// explicit  D(1) K       trace 2 - g - q², det 1 - g
///           trace: q² + 4 ζ q - 4 <= 0, so q <= 2 (sqrt(1 + ζ²) - ζ); det: always
/// exact     D(1) E E K   trace 1 + d - d q², det d
///           trace: d q² <= 2 (1 + d), so q² <= 2 (1 + exp(2 ζ q)); det: always
/// ```
fn semi_implicit(drag: Drag, q: f64, zeta: f64) -> [f64; 2] {
    let (g, d) = (2.0 * zeta * q, (-2.0 * zeta * q).exp());
    match drag {
        Drag::Explicit => [2.0 - g - q * q, 1.0 - g],
        Drag::Exact => [1.0 + d - d * q * q, d],
    }
}

/// Half drift, half of an exact drag, kick, the other half, half drift. A trace does not change where
/// factors go round, so the two half drifts are one.
///
/// ```text
/// explicit  D(½) K D(½)        as D(1) K: trace 2 - g - q², det 1 - g, the limit of semi-implicit Euler
/// exact     D(½) E K E D(½)    as D(1) E K E: trace 1 + s² - s q², det s²
///           trace: s q² <= 2 (1 + s²), so q² <= 2 (s + 1/s) = 4 cosh(ζ q); det: always
/// ```
///
/// At ζ = 0.5 that fails from q = 3.25 and holds again from 5.17: the exponential wins in the end.
fn verlet(drag: Drag, q: f64, zeta: f64) -> [f64; 2] {
    let (g, s) = (2.0 * zeta * q, (-zeta * q).exp());
    match drag {
        Drag::Explicit => [2.0 - g - q * q, 1.0 - g],
        Drag::Exact => [1.0 + s * s - s * q * q, s * s],
    }
}

/// The inequalities as they are solved above, at the limits of both conditions.
#[test]
fn limits_solve_the_inequalities() {
    for zeta in [0.1, 0.5, 1.0, 2.0_f64] {
        let root = (zeta * zeta - 1.0).max(0.0).sqrt();
        let shared = 2.0 * ((1.0 + zeta * zeta).sqrt() - zeta);
        let explicit = [
            if zeta <= 1.0 {
                2.0 * zeta
            } else {
                2.0 * (zeta - root)
            },
            (4.0 * zeta).min(1.0 / zeta),
            shared,
            shared,
        ];
        let exact: [fn(f64) -> f64; 4] = [
            |x| (2.0 * x).exp_m1(),
            |x| 4.0 * x.sinh(),
            |x| 2.0 * (1.0 + (2.0 * x).exp()),
            |x| 4.0 * x.cosh(),
        ];
        for ((law, explicit), square) in LAWS.iter().zip(explicit).zip(exact) {
            let at = |q: f64| format!("{:?} zeta {zeta}: {q}", law.scheme);
            let limit = law.limit(Drag::Explicit, zeta);
            assert!((limit - explicit).abs() <= 1e-12, "{}", at(limit));
            let limit = law.limit(Drag::Exact, zeta);
            let solved = (square(zeta * limit) / limit - limit).abs() <= 1e-12;
            assert!(solved || limit == f64::INFINITY, "{}", at(limit));
        }
    }
    assert!((high_order::RK4.limit(Drag::Explicit, 0.0) - 8.0_f64.sqrt()).abs() <= 1e-12);
}
