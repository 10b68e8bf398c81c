//! Which type fits a scene, how wrong it will be, and what saturates first.
//!
//! The scene is flown once in `f64`, with notes: that gives the range. It is flown again on
//! [`PHASES`](crate::grid::PHASES) grids of a type's unit: that gives the error, and the little that the type itself adds to the
//! range. The finest type that holds all of these flights is the one to take: each further bit behind
//! the point halves the error and costs nothing but range. So the same scene, flown in that type, has
//! all the headroom it needs, and the next finer type saturates.
//!
//! More headroom is for scenes that will be played differently; how much is the author's to say. A
//! bit is twice every position and every speed.

use fixstep::{Error, Force, Ratio, World};

use crate::flight::Plan;
use crate::flown::Flown;
use crate::noted::Noted;
use crate::notes::{Notes, Role};
use crate::spread::{TOO_FAR, spread};

/// What is asked about a scene.
#[derive(Clone, Copy, Debug)]
pub struct Question {
    /// How it is flown.
    pub plan: Plan,
    /// The error that can be borne, m.
    pub bears: f64,
    /// Bits of range to be left free.
    pub headroom: f64,
    /// Types to be looked at beside the best and the next, by their fractional bits.
    pub beside: &'static [u32],
}

/// The types that have names everywhere in this crate.
pub const USUAL: &[u32] = &[12, 16, 20, 24];

/// What a type makes of the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Verdict {
    /// It holds the scene, with this error in the last second.
    Fits(Expected),
    /// It holds the scene, but leaves less of the range free than was asked.
    Tight(Expected),
    /// This saturates, or for a constant is refused.
    Saturates(Role),
}

/// An expected error, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Expected {
    /// The median over the places of the grid.
    pub median: f64,
    /// The largest.
    pub worst: f64,
}

/// A type of 32 bits, and what it makes of the scene.
#[derive(Clone, Copy, Debug)]
pub struct Format {
    /// Bits behind the point.
    pub fraction: u32,
    /// Bits of range that the scene leaves free; below zero what it lacks.
    pub headroom: f64,
    pub verdict: Verdict,
}

/// The answer.
#[derive(Clone, Debug)]
pub struct Advice {
    /// What was asked.
    pub question: Question,
    /// Of the flight in `f64`.
    pub notes: Notes,
    /// The finest type that holds the scene; `None` where none of 32 bits does.
    pub best: Option<Format>,
    /// From coarse to fine: those asked for, the best and the next.
    pub formats: Vec<Format>,
    /// How much further than free motion the scene spreads small changes.
    pub spread: f64,
    /// The power of two at or above the rate, as a shift, and the error of the best type with it.
    pub dyadic: Option<(u32, Expected)>,
}

impl Advice {
    /// What saturates first: in the next finer type, or, if that is only tight, the furthest state.
    pub fn first(&self) -> Option<Role> {
        let is_next = |format: &&Format| Some(format.fraction) == self.best.map(|b| b.fraction + 1);
        match self.formats.iter().find(is_next)?.verdict {
            Verdict::Saturates(role) => Some(role),
            _ => Some(self.notes.widest_held().0),
        }
    }

    /// Whether an error can be told at all.
    pub fn is_sensitive(&self) -> bool {
        self.spread.is_nan() || self.spread >= TOO_FAR
    }
}

/// What a type of 32 bits holds without standing at its end: the largest value but one.
pub fn range(fraction: u32) -> f64 {
    f64::from(i32::MAX - 1) / f64::from(fraction).exp2()
}

/// Advice on the scene that `build` puts into a world. Refuses what every 32-bit type refuses, and
/// a coefficient that grows beyond what one can hold.
pub fn advise<F: Force<Noted>, const N: usize>(
    build: &impl Fn(&mut World<Noted, N>) -> Result<F, Error>,
    question: &Question,
) -> Result<Advice, String> {
    let shown = |error: Error| error.to_string();
    let scene = Flown::new(build, &question.plan, None).map_err(shown)?;
    let coefficient = scene.notes.of(Role::Coefficient).largest;
    if coefficient >= (30.0_f64).exp2() {
        return Err(format!(
            "a coefficient reaches {coefficient:.1e}; 32-bit types hold 2^30"
        ));
    }
    let (mut best, reach) = (None, scene.notes.widest().1);
    let mut next = finest(scene.notes.widest_held().1, question.headroom);
    while let (None, Some(fraction)) = (best, next) {
        let format = scene.format(fraction, question).map_err(shown)?;
        best = matches!(format.verdict, Verdict::Fits(_)).then_some(format);
        next = (1..fraction).next_back();
    }
    let dyadic = best.map(|best: Format| with_dyadic(build, question, best.fraction));
    Ok(Advice {
        question: *question,
        best,
        formats: scene.beside(best, question).map_err(shown)?,
        spread: spread(build, &question.plan, reach * (-32.0_f64).exp2()).map_err(shown)?,
        dyadic: dyadic.transpose().map_err(shown)?,
        notes: scene.notes,
    })
}

/// The most fractional bits whose range is that wide.
fn finest(reach: f64, headroom: f64) -> Option<u32> {
    let need = reach * headroom.exp2();
    (1..32).rev().find(|&fraction| need <= range(fraction))
}

/// The error at the nearest power of two that is no slower; steps are below a quarter second.
fn with_dyadic<F: Force<Noted>, const N: usize>(
    build: &impl Fn(&mut World<Noted, N>) -> Result<F, Error>,
    question: &Question,
    fraction: u32,
) -> Result<(u32, Expected), Error> {
    let shift = question.plan.rate.to_f64().log2().ceil().clamp(3.0, 28.0) as u32;
    let plan = Plan {
        rate: Ratio::new(1 << shift, 1)?,
        ..question.plan
    };
    let scene = Flown::new(build, &plan, Some(shift))?;
    Ok((shift, scene.expected(fraction)?.0))
}
