//! Where the bodies should be: closed forms where there are some, else a reference of high order.
//!
//! ```text
//! spring       x = x0 cos ωt + v0/ω sin ωt                                      ω² = k/m
//! projectile   x = x0 + w t + (v0 - w) (1 - e^-kt)/k          w = g/k, for 1 kg
//! rotor        θ = θ0 + s t + (s0 - s) (1 - e^-kt)/k          s = M / 2πc, k = c/I; first of a place
//! pair         centre uniform; distance L + (d0 - L) cos ωt + u0/ω sin ωt       ω² = k (1/m1 + 1/m2)
//! ```
//!
//! All constants are those of `scenes`; the pair moves along x and drifts along y.

use std::f64::consts::TAU;

use crate::reference;
use crate::rotor::{BEARING, INERTIA, TORQUES};
use crate::scenes::{
    CLUSTER_SOFTENING, DRAG, GRAVITY, HERTZ, PAIR_REST, PAIR_STIFFNESS, SOFTENING,
};
use crate::starts::Dot;

/// Looks a second, at the end of a run: every rate has a tick there.
pub const LOOKS: u32 = 15;

/// Places of all bodies.
pub type Places = Vec<[f64; 2]>;

/// Places at the last second's ticks of 1/15 s, its first included.
pub fn last_second(scene: &str, bodies: &[Dot], seconds: u32) -> Vec<Places> {
    let ticks = LOOKS * (seconds - 1)..=LOOKS * seconds;
    let at = |place: fn(&[Dot], f64) -> Places| {
        let times = ticks.clone().map(|tick| f64::from(tick) / f64::from(LOOKS));
        times.map(|t| place(bodies, t)).collect()
    };
    let step = |acceleration: &reference::Acceleration| {
        let all = reference::path(bodies, acceleration, LOOKS, LOOKS * seconds);
        all[LOOKS as usize * (seconds as usize - 1)..].to_vec()
    };
    match scene {
        "spring" => at(swing),
        "projectile" => at(flight),
        "pair" => at(pair),
        "rotor" => at(turn),
        "quadratic" => step(&reference::air),
        "kepler" => step(&|x, v| reference::stars(SOFTENING.to_f64(), x, v)),
        _ => step(&|x, v| reference::stars(CLUSTER_SOFTENING.to_f64(), x, v)),
    }
}

/// Each on its spring to the origin.
pub fn swing(bodies: &[Dot], t: f64) -> Places {
    let omega = TAU * HERTZ.to_f64();
    let (sin, cos) = (omega * t).sin_cos();
    let along = |x: f64, v: f64| x * cos + v / omega * sin;
    bodies
        .iter()
        .map(|b| [0, 1].map(|i| along(b.x[i], b.v[i])))
        .collect()
}

/// Each through air whose drag is linear.
pub fn flight(bodies: &[Dot], t: f64) -> Places {
    let k = DRAG.to_f64();
    let lost = -(-k * t).exp_m1() / k;
    let along = |x: f64, v: f64, w: f64| x + w * t + (v - w) * lost;
    let wind = [0.0, GRAVITY.to_f64() / k];
    bodies
        .iter()
        .map(|b| [0, 1].map(|i| along(b.x[i], b.v[i], wind[i])))
        .collect()
}

/// Each driven by its motor: turns since the start of the world, and nothing.
pub fn turn(bodies: &[Dot], t: f64) -> Places {
    let [drag, inertia] = [BEARING, INERTIA].map(|ratio| ratio.to_f64());
    let lasting = -(-drag / inertia * t).exp_m1() * inertia / drag;
    let driven = |(b, torque): (&Dot, f64)| {
        let last = torque / (TAU * drag);
        [b.x[0] + last * t + (b.v[0] - last) * lasting, 0.0]
    };
    let torques = TORQUES.map(|torque| torque.to_f64());
    bodies.iter().zip(torques).map(driven).collect()
}

/// Two on a spring.
pub fn pair(bodies: &[Dot], t: f64) -> Places {
    let [a, b] = bodies else { return Vec::new() };
    let (k, rest) = (PAIR_STIFFNESS.to_f64(), PAIR_REST.to_f64());
    let omega = (k * (1.0 / a.mass + 1.0 / b.mass)).sqrt();
    let (sin, cos) = (omega * t).sin_cos();
    let apart = rest + (b.x[0] - a.x[0] - rest) * cos + (b.v[0] - a.v[0]) / omega * sin;
    let weight = b.mass / (a.mass + b.mass);
    let mean = |a: f64, b: f64| a + weight * (b - a);
    let centre = [0, 1].map(|i| mean(a.x[i], b.x[i]) + t * mean(a.v[i], b.v[i]));
    let at = |share: f64| [centre[0] + share * apart, centre[1]];
    vec![at(-weight), at(1.0 - weight)]
}
