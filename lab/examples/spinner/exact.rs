//! What each body does exactly.
//!
//! ```text
//! pushed      v = J / m                 L = r×J
//! braked      v = J / m                 L = r×J exp(-c t / I)
//! gear        v = F/m ∫ (cos θ, sin θ) dt,  θ = θ0 + r F t² / 2I        L = r F t
//! ```
//!
//! L about the own centre; `s = L / 2πI`. The thruster turns with the gear: its torque is constant, and its
//! velocity the spiral of Cornu, whose integrals are Fresnel's; summed here by Simpson's rule.

use std::f64::consts::TAU;

use fixstep::Error;

use crate::lane::{
    BELOW, BURN, DRIVEN_SPEED, DRIVEN_SPIN, GEAR_START, Lane, MASS, NOZZLE, PUSH, RATE, SPIN_DRAG,
    THRUST,
};

/// What is compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    /// m/s.
    pub speed: f64,
    /// turns/s.
    pub spin: f64,
    /// About its own centre, kg m²/s; none of a body that no force moves.
    pub momentum: f64,
}

/// After so many ticks.
pub fn motion(lane: Lane, tick: u32) -> Result<Motion, Error> {
    let (t, burnt) = (seconds(tick), seconds(tick.min(BURN)));
    let speed = PUSH.to_f64() / MASS.to_f64();
    let inertia = lane.inertia()?.to_f64();
    let moment = -BELOW.to_f64() * PUSH.to_f64();
    let (speed, momentum) = match lane {
        Lane::Through => (speed, 0.0),
        Lane::OffCentre => (speed, moment),
        Lane::Braked => (speed, moment * (-SPIN_DRAG.to_f64() * t / inertia).exp()),
        Lane::Gear => (burnt_speed(inertia, burnt), torque() * burnt),
        Lane::Driven => {
            return Ok(Motion {
                speed: DRIVEN_SPEED.to_f64(),
                spin: DRIVEN_SPIN.to_f64(),
                momentum: 0.0,
            });
        }
    };
    Ok(Motion {
        speed,
        spin: momentum / (TAU * inertia),
        momentum,
    })
}

fn seconds(tick: u32) -> f64 {
    f64::from(tick) / f64::from(RATE)
}

/// `r F`, N m.
pub fn torque() -> f64 {
    -NOZZLE.to_f64() * THRUST.to_f64()
}

/// Of the gear after a burn of `t` seconds, m/s. A part of Simpson's rule turns by 1e-2 at most: it is off by
/// 1e-10 of itself.
fn burnt_speed(inertia: f64, t: f64) -> f64 {
    const PARTS: u32 = 2000;
    let start = f64::from(GEAR_START).to_radians();
    let mut sums = [0.0; 2];
    for i in 0..=PARTS {
        let at = t * f64::from(i) / f64::from(PARTS);
        let weight = match i {
            0 | PARTS => 1.0,
            _ => 2.0 + 2.0 * f64::from(i % 2),
        };
        let (sin, cos) = (start + 0.5 * torque() / inertia * at * at).sin_cos();
        sums[0] += weight * cos;
        sums[1] += weight * sin;
    }
    THRUST.to_f64() / MASS.to_f64() * sums[0].hypot(sums[1]) * t / (3.0 * f64::from(PARTS))
}
