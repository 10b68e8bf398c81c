//! A five-hundredth below each limit sixteen swings stay bounded for 100,000 steps, as much above they
//! grow.

use std::f64::consts::E;

use fixstep::{Body, Point};

use crate::stability::law::{DRAGS, Drag, LAWS, Law, radius};
use crate::stability::scene::*;
use crate::support::*;

const STEPS: u32 = 100_000;
const ZETAS: [f64; 5] = [0.0, 0.1, 0.5, 1.0, 2.0];
/// How far from a limit.
const APART: f64 = 0.002;

/// At most by how much a swing is stretched below its limit, in (x, u). Undamped the kept forms tell,
/// the root of the larger of their eigenvalues by the smaller: `x² + u² - q x u` has 1 ± q/2, and `x² +
/// (1 - q²/4) u²` has 1 and 1 - q²/4. Else, as a step M is a root of its own characteristic polynomial,
/// `M^n = a_n M - det a_(n-1)` with `a_n = (λ1^n - λ2^n) / (λ1 - λ2)`, the sum of `λ1^k λ2^(n-1-k)`.
/// With ρ < 1 the larger of the two magnitudes it is at most `2 / |λ1 - λ2|`, and at most `n ρ^(n-1)`,
/// of which the largest is `1 / (e ρ ln(1/ρ))`.
fn stretch(law: &Law, swing: Swing) -> f64 {
    let half = swing.q / 2.0;
    match (swing.zeta == 0.0, law.scheme) {
        (true, Scheme::SemiImplicitEuler) => ((1.0 + half) / (1.0 - half)).sqrt(),
        (true, Scheme::Verlet) => 1.0 / (1.0 - half * half).sqrt(),
        _ => {
            let matrix = swing.matrix(law.scheme);
            let norm = matrix
                .as_flattened()
                .iter()
                .map(|entry| entry * entry)
                .sum::<f64>()
                .sqrt();
            let [trace, det] = (law.spring)(swing.drag, swing.q, swing.zeta);
            let apart = 2.0 / (trace * trace - 4.0 * det).abs().sqrt();
            let rho = radius([trace, det]);
            let slow = 1.0 / (E * rho * (1.0 / rho).ln());
            (if slow > 0.0 { apart.min(slow) } else { apart }) * (norm + det.abs())
        }
    }
}

/// The direction of the smaller eigenvalue, if they are real: from there rounding alone would begin the
/// growth of the larger, or a dead zone end it.
fn decaying(matrix: [[f64; 2]; 2]) -> Option<f64> {
    let [[a, b], _] = matrix;
    let [trace, det] = measured(matrix);
    let square = trace * trace / 4.0 - det;
    let small = trace / 2.0 - trace.signum() * square.sqrt();
    (square >= 0.0).then(|| (small - a).atan2(b))
}

/// The size in (x, u) of both axes of a body; infinite at the end of the range.
fn sizes<S: Number>(body: &Point<S>, omega: f64) -> [f64; 2] {
    let (x, v) = state(body);
    [0, 1].map(|i| match body.is_inside() {
        true => x[i].hypot(v[i] / omega),
        false => f64::INFINITY,
    })
}

/// The largest sizes of sixteen swings, from step `from` on. Ends early where all are at the end of the
/// range, or, so that many steps together are a contraction, a thousandth of their start.
fn run<S: Number>(law: &Law, swing: Swing, size: f64, from: u32) -> [f64; 16] {
    let mut world = swing.world::<S, 8>(starts(size, decaying(swing.matrix(law.scheme))));
    let mut forces = swing.forces(&world);
    let (mut method, step) = (law.scheme.method(), step());
    let mut largest = [0.0_f64; 16];
    for tick in 0..STEPS {
        world.step(&mut method, &mut forces, &step);
        let all: Vec<f64> = world
            .bodies()
            .iter()
            .flat_map(|body| sizes(body, swing.omega()))
            .collect();
        for (largest, size) in largest.iter_mut().zip(&all) {
            if tick >= from || *size == f64::INFINITY {
                *largest = maximum(&[*largest, *size]);
            }
        }
        let gone = largest.iter().all(|&size| size == f64::INFINITY);
        if gone || all.iter().all(|&now| now <= 1e-3 * size) {
            break;
        }
    }
    largest
}

/// Largest sizes by what is allowed: the stretch, longer by a part of the margin that the error of a
/// coefficient takes; and six deviations of rounding, which does not grow but is stretched. Sixteen
/// roundings a step are enough for each method.
fn below<S: Number>(law: &Law, drag: Drag, zeta: f64) -> [f64; 16] {
    let q = (1.0 - APART) * law.limit(drag, zeta);
    let swing = Swing { drag, q, zeta };
    let (stretch, omega) = (stretch(law, swing), swing.omega());
    let size = reach::<S>() / (32.0 * stretch * omega.max(1.0));
    let top = stretch * size;
    let unit = S::unit(top).max(S::unit(top * omega) / omega);
    let noise = 6.0 * (16.0 / 12.0 * f64::from(STEPS)).sqrt() * stretch * unit;
    let allowed = top * (1.0 + S::COEFFICIENT / APART) + noise;
    run::<S>(law, swing, size, 0).map(|largest| largest / allowed)
}

/// What is asked of a swing by what it reaches. Above the limit it grows by the spectral radius a step:
/// by half of its exponent, in the last thousand steps, or by twice what any swing below the limit is
/// stretched, whenever that is; a swing that is clamped may shrink again. Undamped all must be at the
/// end of the range, where one kick a step cannot be clamped and taken back.
fn above<S: Number>(law: &Law, drag: Drag, zeta: f64) -> [f64; 16] {
    let limit = law.limit(drag, zeta);
    let at = |q| Swing { drag, q, zeta };
    let (swing, enough) = (
        at((1.0 + APART) * limit),
        2.0 * stretch(law, at((1.0 - APART) * limit)),
    );
    let size = reach::<S>() / (16.0 * enough * swing.omega().max(1.0));
    let growth = radius((law.spring)(drag, swing.q, zeta)).ln() * f64::from(STEPS);
    let slow = (0.5 * growth).exp();
    let (asked, from) = match slow < enough {
        true => (slow * size, STEPS - 1000),
        false => (enough * size, 0),
    };
    run::<S>(law, swing, size, from).map(|largest| {
        assert!(
            zeta > 0.0 || law.calls > 1 || largest == f64::INFINITY,
            "{} {:?} {swing:?}",
            S::name(),
            law.scheme
        );
        asked / largest
    })
}

/// Both sides of every limit that there is.
pub fn check<S: Number>() {
    for (law, drag) in LAWS.iter().flat_map(|law| DRAGS.map(|drag| (law, drag))) {
        let limits = ZETAS
            .iter()
            .filter(|&&zeta| (0.01..6.0).contains(&law.limit(drag, zeta)));
        let (mut held, mut grown) = (vec![], vec![]);
        for &zeta in limits {
            held.extend(below::<S>(law, drag, zeta));
            grown.extend(above::<S>(law, drag, zeta));
        }
        let what = |side| format!("{} {:?} {drag:?} drag, {side}", S::name(), law.scheme);
        within(1.0, &what("below"), &held);
        within(1.0, &what("above"), &grown);
    }
}
