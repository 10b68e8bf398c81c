//! What a user force does that an engine holds over its substeps.
//!
//! The caller computes `-k z` once; n substeps of semi-implicit Euler, each of `h / n`, keep it:
//!
//! ```text
//! a  = -ω² z
//! v' = v + h a
//! z' = z + h v + (h² a / n²) (1 + 2 + ... + n) = z + h v + h² a (n + 1) / (2 n)
//!
//! det = 1 - w² (n + 1) / (2 n) + w² = 1 + w² (n - 1) / (2 n),  w = h ω
//! ```
//!
//! While the map turns (w is small) both eigenvalues have the modulus `sqrt(det)`, so that the energy,
//! a square, grows by `det` a step. One substep keeps it. Four at 60 Hz and 1 Hz: `1 + 3 w²/8` = 1.00411, twice
//! as much every 168.9 steps; without end in n: `1 + w²/2`, every 126.8. The square that grows by `det`
//! exactly in each step is `c z² + (d - a) z v - b v²` of the map `[a b; c d]`.

use std::f64::consts::{LN_2, TAU};
use std::fmt::Write;

use crate::engine::{Engine, setting};
use crate::problem::{HERTZ, Kind};
use crate::{box2d_2::Box2d2, box2d_3::Box2d3, rapier::Rapier};

const RATE: u32 = 60;
const STEPS: u32 = 600;

/// By which the energy grows in a step.
fn growth(w: f64, substeps: f64) -> f64 {
    1.0 + w * w * (substeps - 1.0) / (2.0 * substeps)
}

/// The square that grows by `det`, of a motion along one axis.
fn square(w: f64, substeps: f64, z: f64, v: f64) -> f64 {
    let h = 1.0 / f64::from(RATE);
    let omega = w / h;
    let (a, b, c, d) = (
        1.0 - w * w * (substeps + 1.0) / (2.0 * substeps),
        h,
        -h * omega * omega,
        1.0,
    );
    c * z * z + (d - a) * z * v - b * v * v
}

/// By which it grows in a step of an engine, on the mean of all starts.
fn measured(engine: &dyn Engine, substeps: usize) -> f64 {
    let kind = Kind::UserSpring;
    let w = TAU * HERTZ / f64::from(RATE);
    let sum = |states: &[crate::problem::State]| -> f64 {
        let axes = states
            .iter()
            .flat_map(|s| [(s.at[0], s.speed[0]), (s.at[1], s.speed[1])]);
        axes.map(|(z, v)| square(w, substeps as f64, z, v)).sum()
    };
    let mut scene = engine.build(kind, &setting("", [substeps, 1]), RATE);
    scene.advance(STEPS);
    (sum(&scene.states()) / sum(&kind.starts())).powf(1.0 / f64::from(STEPS))
}

fn doubling(growth: f64) -> String {
    if growth.ln() > 1e-6 {
        format!("{:.1}", LN_2 / growth.ln())
    } else {
        "never".into()
    }
}

/// Every engine that takes forces from outside: how often the energy doubles.
pub fn table() -> String {
    let mut text = String::from(
        "| engine | substeps | energy doubles every, derived | measured, steps |\n|---|---|---|---|\n",
    );
    let w = TAU * HERTZ / f64::from(RATE);
    for (engine, counts) in cases() {
        for n in counts {
            let _ = writeln!(
                text,
                "| {} | {n} | {} | {} |",
                engine.name(),
                doubling(growth(w, n as f64)),
                doubling(measured(&*engine, n))
            );
        }
    }
    text
}

fn cases() -> Vec<(Box<dyn Engine>, Vec<usize>)> {
    vec![
        (Box::new(Rapier), vec![1, 2, 4, 8]),
        (Box::new(Box2d3), vec![1, 2, 4, 8]),
        (Box::new(Box2d2), vec![1]),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sum over substeps, made step by step; f64 rounds 8 additions of numbers below 3.
    #[test]
    fn the_square_grows_by_the_determinant() {
        let (h, w) = (1.0 / f64::from(RATE), 0.3);
        for n in [1.0, 2.0, 4.0, 8.0] {
            let (mut z, mut v) = (0.7, 2.0);
            let before = square(w, n, z, v);
            let a = -(w / h) * (w / h) * z;
            for _ in 0..n as usize {
                v += h / n * a;
                z += h / n * v;
            }
            let ratio = square(w, n, z, v) / before;
            assert!((ratio - growth(w, n)).abs() <= 1e-13, "{n} {ratio}");
        }
    }

    /// Four substeps at 60 Hz and 1 Hz, in the numbers of the header.
    #[test]
    fn energy_doubles_every_169_steps() {
        let steps = LN_2 / growth(TAU / 60.0, 4.0).ln();
        assert!((steps - 168.9).abs() <= 0.05, "{steps}");
    }

    /// f32 rounds each of 600 steps by up to 1e-7 of a state, so the growth of a step by less than 1e-6.
    #[test]
    fn engines_hold_a_force_over_their_substeps() {
        let w = TAU * HERTZ / f64::from(RATE);
        for (engine, counts) in cases() {
            for n in counts {
                let off = measured(&*engine, n) - growth(w, n as f64);
                assert!(off.abs() <= 1e-6, "{} {n} {off:e}", engine.name());
            }
        }
    }
}
