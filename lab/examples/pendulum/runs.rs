//! Which amplitudes, number types and rates are flown.

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{Error, Point};

use crate::exact;
use crate::swing::{Swing, swing};

/// Degrees to both sides.
pub const AMPLITUDES: [u32; 4] = [10, 45, 90, 150];
/// Steps a second; `f64` also makes twice as many.
pub const RATE: u32 = 240;

/// One pendulum, and what became of it.
#[derive(Clone, Copy, Debug)]
pub struct Run {
    pub degrees: u32,
    pub numbers: &'static str,
    pub rate: u32,
    pub swing: Swing,
    /// The period that `f64` has at that rate: of the method alone.
    pub smooth: f64,
}

impl Run {
    /// Of the period, relatively.
    pub fn error(&self) -> f64 {
        self.swing.period / exact::period(f64::from(self.degrees)) - 1.0
    }
}

/// All number types for each amplitude.
pub fn all() -> Result<Vec<Run>, Error> {
    let mut runs = Vec::new();
    for degrees in AMPLITUDES {
        runs.extend(of(degrees)?);
    }
    Ok(runs)
}

fn of(degrees: u32) -> Result<[Run; 5], Error> {
    let [smooth, fine] = [
        swing::<Point<f64>>(degrees, RATE)?,
        swing::<Point<f64>>(degrees, 2 * RATE)?,
    ];
    let run = |numbers, swing| Run {
        degrees,
        numbers,
        rate: RATE,
        swing,
        smooth: smooth.period,
    };
    let halved = Run {
        rate: 2 * RATE,
        ..run("f64", fine)
    };
    Ok([
        run("f64", smooth),
        halved,
        run("f32", swing::<Point<f32>>(degrees, RATE)?),
        run("I16F16", swing::<Point<I16F16>>(degrees, RATE)?),
        run("I8F24", swing::<Point<I8F24>>(degrees, RATE)?),
    ])
}
