//! Motions without a closed form, in `f64` and by nothing of this crate: extrapolation by Gragg, Bulirsch
//! and Stoer. The modified midpoint rule over one interval H in n substeps has an error in even powers
//! of H/n; eight values of n make order 16.
//!
//! ```text
//! y1 = y0 + h f(y0),  y(i+1) = y(i-1) + 2 h f(yi),  S = (y(n) + y(n-1) + h f(yn)) / 2      h = H/n
//! T(j,k) = T(j,k-1) + (T(j,k-1) - T(j-1,k-1)) / ((n(j)/n(j-k))² - 1)
//! ```
//!
//! Source: Hairer, Norsett, Wanner, "Solving Ordinary Differential Equations I", II.9.

use crate::exact::Places;
use crate::scenes::{GRAVITY, PULL, QUADRATIC};
use crate::starts::Dot;

/// Accelerations by places and velocities; all masses are 1 kg.
pub type Acceleration = dyn Fn(&[[f64; 2]], &[[f64; 2]]) -> Vec<[f64; 2]>;

/// Substeps of the columns.
const COLUMNS: [u32; 8] = [2, 4, 6, 8, 10, 12, 14, 16];
/// Intervals between two looks: twice as many give the same places to 1e-10 m, which a test holds.
const INTERVALS: u32 = 4;

/// Places at the start and at `looks` ticks of `1/rate` s.
pub fn path(bodies: &[Dot], acceleration: &Acceleration, rate: u32, looks: u32) -> Vec<Places> {
    path_in(INTERVALS, bodies, acceleration, rate, looks)
}

/// The same with that many intervals between two looks.
pub fn path_in(
    intervals: u32,
    bodies: &[Dot],
    acceleration: &Acceleration,
    rate: u32,
    looks: u32,
) -> Vec<Places> {
    let length = 1.0 / f64::from(rate * intervals);
    let mut state: State = bodies
        .iter()
        .map(|b| [b.x[0], b.x[1], b.v[0], b.v[1]])
        .collect();
    let places = |state: &State| state.iter().map(|s| [s[0], s[1]]).collect();
    let mut all = vec![places(&state)];
    for _ in 0..looks {
        for _ in 0..intervals {
            state = across(&state, acceleration, length);
        }
        all.push(places(&state));
    }
    all
}

/// x, y and their velocities of each body.
type State = Vec<[f64; 4]>;

fn rates(state: &State, acceleration: &Acceleration) -> State {
    let part = |i| state.iter().map(|s| [s[i], s[i + 1]]).collect::<Vec<_>>();
    let (x, v) = (part(0), part(2));
    let a = acceleration(&x, &v);
    v.iter()
        .zip(a)
        .map(|(v, a)| [v[0], v[1], a[0], a[1]])
        .collect()
}

/// `a + factor (b - c)`
fn plus(a: &State, factor: f64, b: &State, c: &State) -> State {
    let one = |i: usize| [0, 1, 2, 3].map(|k| a[i][k] + factor * (b[i][k] - c[i][k]));
    (0..a.len()).map(one).collect()
}

fn midpoints(start: &State, acceleration: &Acceleration, length: f64, n: u32) -> State {
    let h = length / f64::from(n);
    let zero = vec![[0.0; 4]; start.len()];
    let mut before = start.clone();
    let mut now = plus(start, h, &rates(start, acceleration), &zero);
    for _ in 1..n {
        let next = plus(&before, 2.0 * h, &rates(&now, acceleration), &zero);
        before = std::mem::replace(&mut now, next);
    }
    let end = plus(&before, h, &rates(&now, acceleration), &zero);
    plus(&end, 0.5, &now, &end)
}

fn across(start: &State, acceleration: &Acceleration, length: f64) -> State {
    let mut row: Vec<State> = Vec::new();
    for (j, n) in COLUMNS.into_iter().enumerate() {
        let mut next = vec![midpoints(start, acceleration, length, n)];
        for k in 1..=j {
            let ratio = f64::from(n) / f64::from(COLUMNS[j - k]);
            let better = plus(
                &next[k - 1],
                1.0 / (ratio * ratio - 1.0),
                &next[k - 1],
                &row[k - 1],
            );
            next.push(better);
        }
        row = next;
    }
    row.pop().unwrap_or_default()
}

/// Gravity, and drag with the square of the speed.
pub fn air(_: &[[f64; 2]], v: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let (g, c) = (GRAVITY.to_f64(), QUADRATIC.to_f64());
    let one = |v: &[f64; 2]| {
        let drag = c * v[0].hypot(v[1]);
        [-drag * v[0], g - drag * v[1]]
    };
    v.iter().map(one).collect()
}

/// Stars that pull each other, softened.
pub fn stars(softening: f64, x: &[[f64; 2]], _: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let pull = PULL.to_f64();
    let mut sum = vec![[0.0; 2]; x.len()];
    for (i, from) in x.iter().enumerate() {
        for to in x.iter().take(i).chain(x.iter().skip(i + 1)) {
            let d = [to[0] - from[0], to[1] - from[1]];
            let square = d[0] * d[0] + d[1] * d[1] + softening * softening;
            let factor = pull / (square * square.sqrt());
            sum[i] = [sum[i][0] + factor * d[0], sum[i][1] + factor * d[1]];
        }
    }
    sum
}
