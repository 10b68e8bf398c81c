//! From where the scenes start, how long they run, and which errors count as failures.
//!
//! Every start is a whole number of units of `I16F16`, so that all number types start from it to the bit,
//! and the reference too: how a start is rounded is in no error. All stay within the ±128 of an `I8F24`.

use std::f64::consts::TAU;

use fixstep::Ratio;

use crate::scenes::{HERTZ, MASSES, PAIR_HERTZ};

/// One body: m, m/s, kg. Of a rotor the first of a pair is an angle and a spin: turns, turns/s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dot {
    pub x: [f64; 2],
    pub v: [f64; 2],
    pub mass: f64,
}

/// How a scene is run.
#[derive(Clone, Debug)]
pub struct Plan {
    pub scene: &'static str,
    /// Whole seconds.
    pub seconds: u32,
    /// An error of that size says nothing any more of where a body is, m or turns.
    pub size: f64,
    /// Whether each body is a start of its own, or each world.
    pub alone: bool,
    pub worlds: Vec<Vec<Dot>>,
}

/// Starts of each scene.
pub const STARTS: usize = 16;

impl Plan {
    /// The plan of a scene by its name.
    pub fn of(scene: &'static str) -> Plan {
        let (seconds, size, alone) = match scene {
            "spring" => (10, 1.0, true),
            "projectile" | "quadratic" => (5, 10.0, true),
            "kepler" => (12, 1.0, false),
            "pair" => (10, 1.0, false),
            "rotor" => (6, 0.5, true),
            _ => (6, 1.0, false),
        };
        let start = |i: usize| match scene {
            "spring" => vec![swinging(i)],
            "projectile" | "quadratic" => vec![thrown(i)],
            "kepler" => circling(i),
            "pair" => joined(i),
            "rotor" => vec![spun(i)],
            _ => clustered(i),
        };
        let all: Vec<Vec<Dot>> = (0..STARTS).map(start).collect();
        let worlds = match alone {
            true => all.chunks(4).map(<[_]>::concat).collect(),
            false => all,
        };
        Plan {
            scene,
            seconds,
            size,
            alone,
            worlds,
        }
    }

    /// What an error is counted in.
    pub fn unit(&self) -> &'static str {
        match self.scene {
            "rotor" => "turns",
            _ => "m",
        }
    }

    /// What a picture calls it.
    pub fn title(&self) -> String {
        let what = match self.scene {
            "spring" => "bodies on springs, 0.99 Hz, 1 m",
            "projectile" => "throws into air, linear drag",
            "quadratic" => "throws into air, quadratic drag",
            "kepler" => "two stars, e = 0.1 to 0.6",
            "pair" => "two bodies on a spring",
            "rotor" => "motors in bearings",
            _ => "five stars",
        };
        format!("{what}, {} s", self.seconds)
    }

    /// The same, for longer.
    pub fn lasting(self, seconds: u32) -> Plan {
        Plan { seconds, ..self }
    }
}

/// To the nearest unit of an `I16F16`.
fn dot(x: [f64; 2], v: [f64; 2], mass: f64) -> Dot {
    let rounded = |a: f64| (a * 65536.0).round() / 65536.0;
    let (x, v) = (x.map(rounded), v.map(rounded));
    Dot { x, v, mass }
}

/// Place `i` of a sequence that fills `0..1` evenly; another one for each `which`.
fn spread(which: usize, i: usize) -> f64 {
    let step = [
        0.618_033_988_749_894_9,
        0.754_877_666_246_692_8,
        0.569_840_290_998_053_2,
    ];
    (0.5 + i as f64 * step[which]).fract()
}

fn turned(length: f64, angle: f64) -> [f64; 2] {
    [length * angle.cos(), length * angle.sin()]
}

/// On a circle of 1 m around the anchor, both axes at any phase: amplitude 1 m along each.
fn swinging(i: usize) -> Dot {
    let omega = TAU * HERTZ.to_f64();
    let [a, b] = [0, 1].map(|axis| TAU * spread(axis, i));
    let x = [a.cos(), b.cos()];
    dot(x, [-omega * a.sin(), -omega * b.sin()], 1.0)
}

/// From the origin with 6 to 18 m/s, 20 to 70 degrees above the horizon.
fn thrown(i: usize) -> Dot {
    let (speed, angle) = (
        6.0 + 12.0 * spread(0, i),
        TAU * (20.0 + 50.0 * spread(1, i)) / 360.0,
    );
    dot([0.0; 2], turned(speed, angle), 1.0)
}

/// On an ellipse of a = 1 m and e = 0.1 to 0.6, at any place of it and turned by any angle.
fn circling(i: usize) -> Vec<Dot> {
    let (e, mean) = (0.1 + 0.5 * spread(2, i), TAU * spread(0, i));
    let newton = |at: f64| at - (at - e * at.sin() - mean) / (1.0 - e * at.cos());
    let (sin, cos) = (0..60).fold(TAU / 2.0, |at, _| newton(at)).sin_cos();
    let (minor, rate) = ((1.0 - e * e).sqrt(), 1.0 / (1.0 - e * cos));
    let (s, c) = (TAU * spread(1, i)).sin_cos();
    let half = |[a, b]: [f64; 2]| [(c * a - s * b) / 2.0, (s * a + c * b) / 2.0];
    let (x, v) = (
        half([cos - e, minor * sin]),
        half([-sin * rate, minor * cos * rate]),
    );
    let minus = |[a, b]: [f64; 2]| [-a, -b];
    vec![dot(x, v, 1.0), dot(minus(x), minus(v), 1.0)]
}

/// At any angle, with -1 to 1 turns/s: the torques are those of the four places of a world.
fn spun(i: usize) -> Dot {
    dot([spread(1, i), 0.0], [2.0 * spread(0, i) - 1.0, 0.0], 1.0)
}

/// 2 m apart and at rest but for a swing of 0.5 m along x, with a drift of all.
fn joined(i: usize) -> Vec<Dot> {
    let masses = MASSES.map(Ratio::to_f64);
    let (sin, cos) = (TAU * spread(0, i)).sin_cos();
    let (apart, speed) = (2.0 + 0.5 * cos, -0.5 * TAU * PAIR_HERTZ.to_f64() * sin);
    let drift = [0.5 * spread(1, i), 0.25 * spread(2, i)];
    let body = |share: f64, mass| {
        let v = [drift[0] + share * speed, drift[1]];
        dot([share * apart, 0.0], v, mass)
    };
    let [a, b] = masses;
    vec![body(-b / (a + b), a), body(a / (a + b), b)]
}

/// On a ring of 1.5 m, more or less, turning slower than a ring would keep: they fall towards each other
/// and pass.
fn clustered(i: usize) -> Vec<Dot> {
    let star = |k: usize| {
        let at = 5 * i + k;
        let angle = TAU * (k as f64 + 0.5 * spread(0, at)) / 5.0;
        let (radius, speed) = (1.25 + 0.5 * spread(1, at), 0.5 + 0.25 * spread(2, at));
        dot(turned(radius, angle), turned(speed, angle + TAU / 4.0), 1.0)
    };
    (0..5).map(star).collect()
}
