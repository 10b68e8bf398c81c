//! Where the terminal speed stops attracting, from both sides, in `f64`.
//!
//! Linear drag, `q = k h/m`: `e' = (1 - q) e`, so `e(n) = e(0) (1 - q)^n` stays for q < 2 and explodes
//! beyond. Quadratic drag, `q = c v_t h/m`, with e in units of v_t:
//!
//! ```text
//! e' = (1 - 2 q) e - q e²
//! ```
//!
//! falls to zero for q < 1. Beyond, it does not explode at once: the speed swings between two
//! values `e = a, b` with `b = (1 - 2q) a - q a²` and the reverse. Their difference gives
//! `a + b = 2 (1 - q)/q`, their sum `a² + b² = 4 (q - 1)/q`, together
//! `|a - b| = 2 sqrt(q² - 1)/q`. The slope over two steps there is `1 - 8 d - 4 d²` with
//! `d = q - 1`, so the swing attracts.
//!
//! h is 1/64 s, the mass 1 kg and v_t a power of two for quadratic drag: q and g h are exact.

use fixstep::{DyadicStep, Force, GravityY, LinearDrag, Point, QuadraticDrag};

use crate::support::{SCHEMES, Scheme, point, ratio, spread, within, world};

/// Steps a second.
const RATE: f64 = 64.0;
/// The most by which one operation rounds, relatively.
const ROUNDING: f64 = f64::EPSILON / 2.0;

/// The speed before the first step and after each.
fn speeds(scheme: Scheme, mut forces: impl Force<Point<f64>>, start: f64, ticks: u32) -> Vec<f64> {
    let step = DyadicStep::<f64, 1, 6>::new().unwrap();
    let mut world = world::<_, 1>([point([0.0, 0.0], [0.0, -start], 1.0)]);
    let (mut method, mut seen) = (scheme.method(), vec![start]);
    for _ in 0..ticks {
        world.step(&mut method, &mut forces, &step);
        seen.push(-world.bodies()[0].velocity().y);
    }
    seen
}

fn gravity(g: f64) -> GravityY<f64> {
    GravityY::new(ratio(-g)).unwrap()
}

/// Distances from the edge: sixteen of 1/64 and more.
fn distances() -> impl Iterator<Item = f64> {
    (4..20).map(|i| f64::from(i) / 256.0)
}

/// All errors, and the largest share that one has of its tolerance. A step rounds `v + g h`, `q v`
/// and the new v: each below `2.2 (v_t + |e|)` roundings. An error grows as e does, so n of them
/// have grown to `7 n (v_t + e(0)) max(1, |1 - q|^n)` roundings; v_t itself and the expected power
/// are within another.
fn linear(scheme: Scheme, q: f64, g: f64, ticks: u32) -> (Vec<f64>, f64) {
    let k = RATE * q;
    let (terminal, factor) = (g / k, 1.0 - q);
    let drag = LinearDrag::new(ratio(k)).unwrap();
    let speeds = speeds(scheme, (gravity(g), drag), terminal + 1.0, ticks);
    let errors: Vec<f64> = speeds.iter().map(|v| v - terminal).collect();
    let (mut worst, mut expected) = (0.0, errors[0]);
    for (n, error) in (1..).map(f64::from).zip(&errors) {
        let scale = (terminal + 1.0) * expected.abs().max(1.0);
        let share = (error - expected).abs() / (8.0 * n * scale * ROUNDING);
        worst = if share <= worst { worst } else { share };
        expected *= factor;
    }
    (errors, worst)
}

#[test]
fn linear_drag_stays_just_below_2_and_explodes_just_above() {
    for scheme in SCHEMES {
        let (mut shares, mut left, mut grown) = (vec![], vec![], vec![]);
        for (i, d) in distances().enumerate() {
            let (g, ticks) = (4.0 + 8.0 * spread(i), (16.0 / d) as u32);
            let (below, share) = linear(scheme, 2.0 - d, g, ticks);
            shares.push(share);
            left.extend(below.last().map(|e| e.abs()));
            let (above, share) = linear(scheme, 2.0 + d, g, ticks);
            shares.push(share);
            grown.extend(above.last().map(|e| 1.0 / e.abs()));
        }
        within(1.0, &format!("{scheme:?}, recursion in bounds"), &shares);
        // (1 - d)^(16/d) < e^-16 but for a tick that is cut; (1 + d)^(16/d) > e^15.
        within(1.2e-7, &format!("{scheme:?}, left below 2"), &left);
        within(1e-6, &format!("{scheme:?}, 1 / grown above 2"), &grown);
    }
}

/// Two last errors in units of v_t, from 2^-10.
fn quadratic(scheme: Scheme, q: f64, terminal: f64, ticks: u32) -> [f64; 2] {
    let drag = QuadraticDrag::new(ratio(RATE * q / terminal)).unwrap();
    let forces = (gravity(RATE * q * terminal), drag);
    let start = terminal * (1.0 + 2.0_f64.powi(-10));
    let speeds = speeds(scheme, forces, start, ticks);
    [2, 1].map(|back| speeds[speeds.len() - back] / terminal - 1.0)
}

/// In roundings of v_t a step makes 2 for `v + g h`, 1 for the new v, 3.5 for the kick: half for v²,
/// 1 each for its root, the product and the kick. Below 1 an error loses 1.9 d of itself in a step,
/// so `6.6/(1.9 d)` stay; in 20/d steps e falls by e^-38. Above, v reaches 1.3 v_t and a step makes
/// 10 roundings; two steps lose 8 d of the distance to the swing, which 20/d steps so reach, and the
/// slope between them is 1.8 at most: `10 (1 + 1.8)/(8 d)` at each end, `7/d` in all.
#[test]
fn quadratic_drag_stays_just_below_1_and_swings_just_above() {
    for scheme in SCHEMES {
        let (mut left, mut swings) = (vec![], vec![]);
        for (i, d) in distances().enumerate() {
            let (terminal, ticks) = (2.0_f64.powi(i as i32 % 4), (20.0 / d) as u32);
            let bound = 8.0 * ROUNDING / d;
            let [a, b] = quadratic(scheme, 1.0 - d, terminal, ticks);
            left.push((a.abs() + b.abs()) / 2.0 / bound);
            let q: f64 = 1.0 + d;
            let [a, b] = quadratic(scheme, q, terminal, ticks);
            let swing = 2.0 * (q * q - 1.0).sqrt() / q;
            swings.push(((a - b).abs() - swing).abs() / bound);
        }
        within(1.0, &format!("{scheme:?}, left below 1, in bounds"), &left);
        within(
            1.0,
            &format!("{scheme:?}, swing above 1, in bounds"),
            &swings,
        );
    }
}
