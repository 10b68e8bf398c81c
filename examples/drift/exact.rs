//! Where a law takes its bodies, in closed form.
//!
//! ```text
//! gravity    d = v t + g t²/2
//! drag       d = v p + (g/c) (t - p)          c = k/m,  p = (1 - e^(-c t)) / c
//! anchor     d = x (cos wt - 1) + v/w sin wt  w² = k/m
//! spring     d = V t -/+ s m'/(m + m')        s = (L - rest) (cos wt - 1),  w² = k (1/m + 1/m')
//! ```
//!
//! Displacements, not positions: a body far out loses nothing to the distance. `cos - 1` is written
//! as `-2 sin²(wt/2)` and `1 - e^x` as `-expm1(x)`, so that small times are exact too.

use fixstep::Vec2;

use crate::scene::{Law, Start};

/// How far each body is from its start after `t` seconds.
pub fn displacements(law: Law, bodies: &[Start], t: f64) -> Vec<Vec2<f64>> {
    let each = |law: &dyn Fn(&Start) -> Vec2<f64>| bodies.iter().map(law).collect();
    match law {
        Law::Free => each(&|body| body.velocity.scaled(t)),
        Law::Gravity { g } => each(&|body| body.velocity.scaled(t) + down(0.5 * g * t * t)),
        Law::Drag { k } => each(&|body| ballistic(body, 0.0, k, t)),
        Law::GravityAndDrag { g, k } => each(&|body| ballistic(body, g, k, t)),
        Law::Anchor { k } => each(&|body| anchored(body, k, t)),
        Law::Spring { k, rest } => pair(bodies, k, rest, t),
    }
}

fn down(distance: f64) -> Vec2<f64> {
    Vec2::new(0.0, -distance)
}

fn ballistic(body: &Start, g: f64, k: f64, t: f64) -> Vec2<f64> {
    let c = k / body.mass;
    let p = -(-c * t).exp_m1() / c;
    body.velocity.scaled(p) + down(g / c * (t - p))
}

fn anchored(body: &Start, k: f64, t: f64) -> Vec2<f64> {
    let w = (k / body.mass).sqrt();
    body.position.scaled(cos_less_one(w * t)) + body.velocity.scaled((w * t).sin() / w)
}

/// The centre of mass moves on evenly; the length swings about `rest`.
fn pair(bodies: &[Start], k: f64, rest: f64, t: f64) -> Vec<Vec2<f64>> {
    let [a, b] = bodies else {
        return Vec::new();
    };
    let along = b.position - a.position;
    let length = along.length();
    let w = (k * (1.0 / a.mass + 1.0 / b.mass)).sqrt();
    let swing = along.scaled((length - rest) / length * cos_less_one(w * t));
    let share = |other: &Start| swing.scaled(other.mass / (a.mass + b.mass));
    let drift = a.velocity.scaled(t);
    vec![drift - share(b), drift + share(a)]
}

fn cos_less_one(angle: f64) -> f64 {
    let half = (0.5 * angle).sin();
    -2.0 * half * half
}
