//! What falls: masses, gravities and drags, and the exact terminal speed of each.
//!
//! ```text
//! linear      F = -k v        v_t = m g / k          v(t) = v_t (1 - exp(-k t/m))
//! quadratic   F = -c |v| v    v_t = sqrt(m g / c)    v(t) = v_t tanh(g t/v_t)
//! ```
//!
//! Both have `q = g h / v_t`, the share of the speed that drag takes in a step: `k h/m`, `c v_t h/m`.
//! From rest both come closer to v_t at least as fast as `(1 - q)^n`.

use crate::support::{ratio, spread};

/// Steps a second.
pub const RATE: u32 = 60;

/// Terminal speeds, m/s: ten a decade, as Renard rounds them.
pub const SPEEDS: [f64; 21] = [
    0.5, 0.63, 0.8, 1.0, 1.25, 1.6, 2.0, 2.5, 3.15, 4.0, 5.0, 6.3, 8.0, 10.0, 12.5, 16.0, 20.0,
    25.0, 31.5, 40.0, 50.0,
];

/// Falls for each law and speed.
pub const FALLS: usize = 16;

/// How drag depends on the speed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    Linear,
    Quadratic,
}

impl Law {
    pub const BOTH: [Law; 2] = [Law::Linear, Law::Quadratic];

    /// Of the speed in the drag.
    pub fn power(self) -> f64 {
        match self {
            Law::Linear => 1.0,
            Law::Quadratic => 2.0,
        }
    }
}

/// One body and what acts on it: kg, m/s², kg/s or kg/m.
#[derive(Clone, Copy, Debug)]
pub struct Fall {
    pub law: Law,
    pub mass: f64,
    pub gravity: f64,
    pub drag: f64,
}

impl Fall {
    /// With about that terminal speed; [`Fall::speed`] is the exact one.
    pub fn new(law: Law, mass: f64, gravity: f64, speed: f64) -> Fall {
        let drag = match law {
            Law::Linear => mass * gravity / speed,
            Law::Quadratic => mass * gravity / (speed * speed),
        };
        // Constructors take a ratio, which may have fewer digits.
        let drag = ratio(drag).to_f64();
        Fall {
            law,
            mass,
            gravity,
            drag,
        }
    }

    /// Fall `i` of a sequence that spreads gravities over 4..12 m/s² and masses over 0.1..10 kg.
    pub fn spread(law: Law, speed: f64, i: usize) -> Fall {
        let gravity = 4.0 + 8.0 * spread(i);
        let mass = 0.1 + 9.9 * spread(7 * i + 3);
        Fall::new(law, mass, gravity, speed)
    }

    /// The exact terminal speed, m/s.
    pub fn speed(&self) -> f64 {
        let ratio = self.mass * self.gravity / self.drag;
        match self.law {
            Law::Linear => ratio,
            Law::Quadratic => ratio.sqrt(),
        }
    }

    /// What gravity adds to the speed in a step, m/s.
    pub fn gain(&self) -> f64 {
        self.gravity / f64::from(RATE)
    }

    /// The share of the terminal speed that drag takes in a step.
    pub fn share(&self) -> f64 {
        self.gain() / self.speed()
    }
}
