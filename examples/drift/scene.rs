//! The scenes, as data: a law of motion, start values, a length, what to compare and what is kept.
//!
//! All numbers are real numbers here (`f64`); each scalar rounds them for itself. A scene is flown
//! from [`STARTS`] start values, so that one lucky rounding does not speak for a number type.

use std::f64::consts::TAU;

use fixstep::{Ratio, Vec2};

/// Start values of each scene.
pub const STARTS: usize = 16;

/// The forces of a scene, with their coefficients.
#[derive(Clone, Copy, Debug)]
pub enum Law {
    /// No force.
    Free,
    /// `a = g` (m/s²), downwards.
    Gravity { g: f64 },
    /// `F = -k v` (kg/s).
    Drag { k: f64 },
    /// Both.
    GravityAndDrag { g: f64, k: f64 },
    /// `F = -k x` (N/m), a spring to the origin.
    Anchor { k: f64 },
    /// A spring (N/m) of length `rest` (m) between two bodies that set out with one velocity.
    Spring { k: f64, rest: f64 },
}

/// A body at the start.
#[derive(Clone, Copy, Debug)]
pub struct Start {
    pub position: Vec2<f64>,
    pub velocity: Vec2<f64>,
    pub mass: f64,
}

/// How far apart two states are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Compare {
    /// The distance between positions.
    Positions,
    /// The same on a circle of this many metres, so that every type can fly any distance.
    OnCircle(u32),
    /// How much the second body's displacement differs from the first's.
    SecondToFirst,
}

/// How long a scene runs.
#[derive(Clone, Copy, Debug)]
pub enum Length {
    Seconds(f64),
    Steps(u64),
}

/// What the law keeps, so that a change of it is an error.
#[derive(Clone, Copy, Debug)]
pub struct Kept {
    pub energy: bool,
    pub momentum: bool,
}

#[derive(Clone, Copy, Debug)]
pub struct Scene {
    pub name: &'static str,
    pub title: &'static str,
    pub law: Law,
    pub length: Length,
    pub compare: Compare,
    pub kept: Kept,
    /// The bodies for a variation from 0 to 1 and, in the far scene, a distance from the origin.
    bodies: fn(f64, f64) -> Vec<Start>,
}

impl Scene {
    /// The bodies of start `index`. Start 0 has the figures of the title; the others spread evenly
    /// by the golden ratio.
    pub fn bodies(&self, index: usize, distance: f64) -> Vec<Start> {
        (self.bodies)((index as f64 * 0.618_033_988_75).fract(), distance)
    }

    /// Steps of a run at `rate` steps per second, for the scene's own length or for `seconds`.
    pub fn steps(&self, rate: Ratio, seconds: Option<f64>) -> u64 {
        let steps = |seconds: f64| (seconds * rate.to_f64()).round() as u64;
        match (seconds, self.length) {
            (Some(seconds), _) | (None, Length::Seconds(seconds)) => steps(seconds),
            (None, Length::Steps(steps)) => steps,
        }
    }
}

const ENERGY: Kept = Kept {
    energy: true,
    momentum: false,
};
const BOTH: Kept = Kept {
    energy: true,
    momentum: true,
};
const NOTHING: Kept = Kept {
    energy: false,
    momentum: false,
};

/// Every scene, in the order of the report.
pub static ALL: [Scene; 9] = [
    Scene {
        name: "fall-5",
        title: "Free fall at the article's 5 units/s²",
        law: Law::Gravity { g: 5.0 },
        length: Length::Seconds(6.0),
        compare: Compare::Positions,
        kept: ENERGY,
        bodies: fall,
    },
    Scene {
        name: "fall-9.81",
        title: "Free fall at 9.81 m/s²",
        law: Law::Gravity { g: 9.81 },
        length: Length::Seconds(6.0),
        compare: Compare::Positions,
        kept: ENERGY,
        bodies: fall,
    },
    Scene {
        name: "friction",
        title: "Friction f = -v on 1 kg",
        law: Law::Drag { k: 1.0 },
        length: Length::Seconds(20.0),
        compare: Compare::Positions,
        kept: NOTHING,
        bodies: |u, _| vec![body((0.0, 0.0), (8.0 + 4.0 * u, 3.0 * u - 5.0), 1.0)],
    },
    Scene {
        name: "projectile",
        title: "Projectile of 1.5 kg with drag 0.6 kg/s at 9.81 m/s²",
        law: Law::GravityAndDrag { g: 9.81, k: 0.6 },
        length: Length::Seconds(4.0),
        compare: Compare::Positions,
        kept: NOTHING,
        bodies: |u, _| vec![body((0.0, 0.0), (12.0 + 2.0 * u, 16.0 + 2.0 * u), 1.5)],
    },
    Scene {
        name: "spring",
        title: "Spring of 17.3 N/m on 1.37 kg (0.5656 Hz), amplitude 1 m",
        law: Law::Anchor { k: SPRING.0 },
        length: Length::Seconds(600.0),
        compare: Compare::Positions,
        kept: ENERGY,
        bodies: spring,
    },
    Scene {
        name: "pair-1-3",
        title: "1 kg and 3 kg on a spring, drifting together",
        law: Law::Spring { k: 20.0, rest: 2.0 },
        length: Length::Seconds(120.0),
        compare: Compare::Positions,
        kept: BOTH,
        bodies: |u, _| pair(u, [1.0, 3.0]),
    },
    Scene {
        name: "pair-1.37-2.91",
        title: "1.37 kg and 2.91 kg on a spring, drifting together",
        law: Law::Spring { k: 20.0, rest: 2.0 },
        length: Length::Seconds(120.0),
        compare: Compare::Positions,
        kept: BOTH,
        bodies: |u, _| pair(u, [1.37, 2.91]),
    },
    Scene {
        name: "cruise",
        title: "Cruise at a constant 1.2345 m/s, wrapped at 64 m",
        law: Law::Free,
        length: Length::Steps(1_000_000),
        compare: Compare::OnCircle(64),
        kept: BOTH,
        bodies: |u, _| vec![body((0.0, 0.0), (1.2345 * (1.0 + u), 0.0), 1.0)],
    },
    Scene {
        name: "far",
        title: "A throw far out (fixed: 0.9 of the range, floats: 100 km) beside the same at the origin",
        law: Law::Gravity { g: 9.81 },
        length: Length::Seconds(2.0),
        compare: Compare::SecondToFirst,
        kept: NOTHING,
        bodies: |u, distance| {
            [0.0, distance]
                .map(|at| body((at, at), (2.0 + u, 4.0 - u), 1.0))
                .to_vec()
        },
    },
];

fn body(position: (f64, f64), velocity: (f64, f64), mass: f64) -> Start {
    Start {
        position: Vec2::new(position.0, position.1),
        velocity: Vec2::new(velocity.0, velocity.1),
        mass,
    }
}

fn fall(u: f64, _: f64) -> Vec<Start> {
    vec![body((0.0, 100.0 + 8.0 * u), (0.0, u), 1.0)]
}

/// Stiffness and mass of the anchored spring.
const SPRING: (f64, f64) = (17.3, 1.37);

/// Amplitude 1 m at any phase.
fn spring(u: f64, _: f64) -> Vec<Start> {
    let (k, mass) = SPRING;
    let (sin, cos) = (TAU * u).sin_cos();
    vec![body((cos, 0.0), (-(k / mass).sqrt() * sin, 0.0), mass)]
}

/// Drawn out by half a metre or more along a line that is neither axis.
fn pair(u: f64, masses: [f64; 2]) -> Vec<Start> {
    let length = 2.5 + 0.5 * u;
    let ends = [(-20.0, 12.0), (-20.0 + 0.6 * length, 12.0 + 0.8 * length)];
    [0, 1]
        .map(|i| body(ends[i], (0.35, -0.2), masses[i]))
        .to_vec()
}
