//! The command line. A bad value ends the run with exit code 2.

use clap::Parser;
use fixstep::fixed::types::I16F16;
use fixstep::{Ratio, Step};

use crate::advise::{Question, USUAL};
use crate::flight::{Plan, Scheme};
use crate::rotor;
use crate::scene::{self, Compare, Scene};

/// Which fixed-point type fits a scene, and how wrong it will be.
#[derive(Debug, Parser)]
#[command(name = "qformat", max_term_width = 100)]
pub struct Options {
    /// A scene of the drift example, or how its name begins: fall, friction, projectile, spring, pair,
    /// cruise, far; or rotor, of bodies that turn
    #[arg(long, value_name = "NAME", default_value = "projectile", value_parser = named)]
    pub scene: Asked,

    /// The error that can be borne, m
    #[arg(long, value_name = "METRES", default_value = "0.001", value_parser = positive)]
    pub error: f64,

    /// Steps per second: a decimal above 4
    #[arg(long, value_name = "RATE", default_value = "60", value_parser = rate)]
    pub hz: Ratio,

    /// Simulated seconds. Each scene has its own by default
    #[arg(long, value_name = "TIME", value_parser = seconds)]
    pub seconds: Option<f64>,

    /// Bits of range to leave free, for scenes that are played differently
    #[arg(long, value_name = "BITS", default_value = "0", value_parser = headroom)]
    pub headroom: f64,

    /// What makes the steps
    #[arg(long, value_name = "NAME", default_value = "verlet")]
    pub method: Scheme,

    /// How far out the second body of the far scene starts, m
    #[arg(long, value_name = "METRES", default_value = "29491.2", value_parser = positive)]
    pub distance: f64,
}

impl Options {
    /// What they ask about the scene.
    pub fn question(&self) -> Question {
        let (steps, circle) = match self.scene {
            Asked::Drift(scene) => {
                let circle = match scene.compare {
                    Compare::OnCircle(metres) => Some(metres),
                    _ => None,
                };
                (scene.steps(self.hz, self.seconds), circle)
            }
            Asked::Rotor => {
                let seconds = self.seconds.unwrap_or(rotor::SECONDS);
                ((seconds * self.hz.to_f64()).round() as u64, None)
            }
        };
        Question {
            plan: Plan {
                method: self.method,
                rate: self.hz,
                seconds: steps as f64 / self.hz.to_f64(),
                circle,
            },
            bears: self.error,
            headroom: self.headroom,
            beside: USUAL,
        }
    }
}

/// A scene that can be asked about.
#[derive(Clone, Copy, Debug)]
pub enum Asked {
    Drift(&'static Scene),
    /// Of bodies that turn.
    Rotor,
}

fn named(text: &str) -> Result<Asked, String> {
    if !text.is_empty() && rotor::NAME.starts_with(text) {
        return Ok(Asked::Rotor);
    }
    let mut all = scene::ALL.iter();
    all.find(|scene| !text.is_empty() && scene.name.starts_with(text))
        .map(Asked::Drift)
        .ok_or_else(|| {
            let names: Vec<&str> = scene::ALL.iter().map(|scene| scene.name).collect();
            format!("not one of {}, {}", names.join(", "), rotor::NAME)
        })
}

fn rate(text: &str) -> Result<Ratio, String> {
    let rate = Ratio::parse(text).map_err(|_| "not a plain decimal".to_string())?;
    // A second of places is kept.
    if rate.to_f64() > 1e5 {
        return Err("more than 10^5 Hz".to_string());
    }
    Step::<I16F16>::hz(rate).map_err(|error| error.to_string())?;
    Ok(rate)
}

fn positive(text: &str) -> Result<f64, String> {
    not_negative(text).and_then(|value| match value {
        0.0 => Err("not greater than zero".to_string()),
        value => Ok(value),
    })
}

/// The scene is flown some fifty times.
fn seconds(text: &str) -> Result<f64, String> {
    positive(text).and_then(|seconds| match seconds {
        seconds if seconds <= 1e6 => Ok(seconds),
        _ => Err("more than 10^6 s".to_string()),
    })
}

fn headroom(text: &str) -> Result<f64, String> {
    not_negative(text).and_then(|bits| match bits {
        bits if bits <= 16.0 => Ok(bits),
        _ => Err("more than 16 bits".to_string()),
    })
}

fn not_negative(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() && value >= 0.0 => Ok(value),
        _ => Err("not a number from zero".to_string()),
    }
}
