//! What is run, and where it should be: problems without contacts, each with its exact solution.
//!
//! ```text
//! fall, drag, projectile   v' = g - γ v     v = u + (v0 - u) exp(-γ t),  u = g / γ
//! springs                  z'' = -ω² z - 2 ζ ω z',  z = x - rest
//! ```
//!
//! All masses are 1 kg. Start values are multiples of 1/64, which every number type here holds: no error
//! comes from writing them down.

use std::f64::consts::TAU;

/// Of one body: m and m/s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    pub at: [f64; 2],
    pub speed: [f64; 2],
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Gravity alone.
    Fall,
    /// Linear drag alone, by the engine's own damping.
    Drag,
    /// Gravity and linear drag.
    Projectile,
    /// The caller computes `-k z` before every step.
    UserSpring,
    /// The engine's own spring: a joint of rest length [`LENGTH`], pulled along its axis.
    OwnSpring,
    /// The same with a damping ratio of [`RATIO`].
    DampedSpring,
}

/// Every problem, in the order of the table.
pub const ALL: [Kind; 6] = [
    Kind::Fall,
    Kind::Drag,
    Kind::Projectile,
    Kind::UserSpring,
    Kind::OwnSpring,
    Kind::DampedSpring,
];

/// Downwards, m/s².
pub const GRAVITY: f64 = 9.81;
/// Undamped; no multiple of it is a rate, so that no step falls on the same phase again and again.
pub const HERTZ: f64 = 1.03;
/// Of the damped spring.
pub const RATIO: f64 = 0.1;
/// Of a joint at rest, m; it ends at the origin.
pub const LENGTH: f64 = 2.0;
/// Bodies in a run.
pub const STARTS: usize = 16;

impl Kind {
    pub fn name(self) -> &'static str {
        match self {
            Kind::Fall => "free fall",
            Kind::Drag => "linear drag",
            Kind::Projectile => "projectile with drag",
            Kind::UserSpring => "spring as user force",
            Kind::OwnSpring => "own spring",
            Kind::DampedSpring => "own spring with damper",
        }
    }

    /// Length of a run, s.
    pub fn seconds(self) -> u32 {
        match self {
            // Short, so that something is left of the damped spring: a quarter of its amplitude.
            Kind::Fall | Kind::DampedSpring => 2,
            Kind::Drag => 4,
            Kind::Projectile => 3,
            _ => 10,
        }
    }

    pub fn gravity(self) -> f64 {
        match self {
            Kind::Fall | Kind::Projectile => GRAVITY,
            _ => 0.0,
        }
    }

    /// γ, 1/s.
    pub fn drag(self) -> f64 {
        match self {
            Kind::Drag => 0.5,
            Kind::Projectile => 0.3,
            _ => 0.0,
        }
    }

    pub fn damping_ratio(self) -> f64 {
        if self == Kind::DampedSpring {
            RATIO
        } else {
            0.0
        }
    }

    pub fn is_spring(self) -> bool {
        matches!(
            self,
            Kind::UserSpring | Kind::OwnSpring | Kind::DampedSpring
        )
    }

    /// Spread evenly, by multiples of two irrational numbers.
    pub fn starts(self) -> Vec<State> {
        let spread = |i: usize, by: f64| (i as f64 * by).fract();
        let grid = |value: f64| (value * 64.0).round() / 64.0;
        (0..STARTS)
            .map(|i| {
                let (a, b) = (spread(i, 0.618_034), spread(i, 0.754_878));
                let (at, speed) = match self {
                    Kind::Fall | Kind::Drag => ([4.0 * a, 2.0 * b], [2.0 + 6.0 * b, 4.0 * a - 2.0]),
                    Kind::Projectile => ([0.0, 2.0 * a], [4.0 + 8.0 * b, 4.0 + 8.0 * a]),
                    Kind::UserSpring => ([0.25 + 0.5 * a, 0.5 * b], [2.0 * b, 2.0 * a - 1.0]),
                    // Along the joint alone, and never as far as its other end.
                    _ => ([LENGTH + 0.25 + 0.5 * a, 0.0], [3.0 * b - 1.5, 0.0]),
                };
                State {
                    at: at.map(grid),
                    speed: speed.map(grid),
                }
            })
            .collect()
    }

    /// Where a spring rests.
    pub fn rest(self) -> [f64; 2] {
        match self {
            Kind::OwnSpring | Kind::DampedSpring => [LENGTH, 0.0],
            _ => [0.0, 0.0],
        }
    }

    /// The exact state after `t` seconds.
    pub fn exact(self, start: &State, t: f64) -> State {
        let pulls = [0.0, -self.gravity()];
        let axis = |i: usize| {
            if self.is_spring() {
                let rest = self.rest()[i];
                let [z, v] = swing(self.damping_ratio(), start.at[i] - rest, start.speed[i], t);
                [rest + z, v]
            } else {
                fly(pulls[i], self.drag(), start.at[i], start.speed[i], t)
            }
        };
        let ([x, vx], [y, vy]) = (axis(0), axis(1));
        State {
            at: [x, y],
            speed: [vx, vy],
        }
    }

    /// Distance of two states, m: speeds count by the time in which the problem changes them, `1/ω`,
    /// `1/γ`, or 1 s.
    pub fn distance(self, a: &State, b: &State) -> f64 {
        let time = match self {
            Kind::Fall => 1.0,
            Kind::Drag | Kind::Projectile => 1.0 / self.drag(),
            _ => 1.0 / (TAU * HERTZ),
        };
        let square =
            |i: usize| (a.at[i] - b.at[i]).powi(2) + (time * (a.speed[i] - b.speed[i])).powi(2);
        (square(0) + square(1)).sqrt()
    }
}

fn fly(g: f64, drag: f64, x: f64, v: f64, t: f64) -> [f64; 2] {
    if drag == 0.0 {
        return [x + v * t + 0.5 * g * t * t, v + g * t];
    }
    let (end, left) = (g / drag, (-drag * t).exp());
    [
        x + end * t + (v - end) * (1.0 - left) / drag,
        end + (v - end) * left,
    ]
}

fn swing(ratio: f64, z: f64, v: f64, t: f64) -> [f64; 2] {
    let omega = TAU * HERTZ;
    let (loss, turn) = (ratio * omega, omega * (1.0 - ratio * ratio).sqrt());
    let (sin, cos) = (turn * t).sin_cos();
    let (left, b) = ((-loss * t).exp(), (v + loss * z) / turn);
    [
        left * (z * cos + b * sin),
        left * ((b * turn - loss * z) * cos - (z * turn + loss * b) * sin),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The law itself, by the exact solution's own difference quotients: of order `d²` with d = 1e-4 s,
    /// times the third derivative, below `ω³ * 2 m/s` = 600; and rounding, `1e-16 * 50 / 1e-4`.
    #[test]
    fn exact_solutions_obey_their_laws() {
        let d = 1e-4;
        for kind in ALL {
            for start in kind.starts() {
                for t in [0.3, 1.7] {
                    let [before, now, after] = [t - d, t, t + d].map(|t| kind.exact(&start, t));
                    for i in 0..2 {
                        let speed = (after.at[i] - before.at[i]) / (2.0 * d);
                        assert!((speed - now.speed[i]).abs() <= 1e-5, "{kind:?}");
                        let gain = (after.speed[i] - before.speed[i]) / (2.0 * d);
                        let omega = if kind.is_spring() { TAU * HERTZ } else { 0.0 };
                        let law = [0.0, -kind.gravity()][i]
                            - kind.drag() * now.speed[i]
                            - omega * omega * (now.at[i] - kind.rest()[i])
                            - 2.0 * kind.damping_ratio() * omega * now.speed[i];
                        assert!((gain - law).abs() <= 1e-4, "{kind:?} {gain} {law}");
                    }
                }
                assert!(kind.distance(&kind.exact(&start, 0.0), &start) <= 1e-15);
            }
        }
    }

    #[test]
    fn starts_differ_and_fit_every_number_type() {
        for kind in ALL {
            let starts = kind.starts();
            for (i, start) in starts.iter().enumerate() {
                let numbers = [start.at, start.speed].concat();
                assert!(
                    numbers
                        .iter()
                        .all(|x| (x * 64.0).fract() == 0.0 && x.abs() < 16.0)
                );
                assert!(starts[..i].iter().all(|other| other != start), "{kind:?}");
            }
        }
    }
}
