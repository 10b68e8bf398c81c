//! What rounding does, as a theory that `f64` can follow: the residues of products are anyone's guess.
//!
//! A type with unit u makes of a product p the nearest multiple of u. How far off that is depends on the
//! digits behind the unit, which nobody chose: for any other start of the same scene they are
//! others. But they are not noise: a product that stays the same is rounded the same way in each
//! step, so a cruise errs by N steps and not by the root of N; opposite products have opposite errors; and
//! what is less than half a unit is nothing, as it is in a dead zone; and what is a whole number of
//! units is left alone. All this stays if the grid is moved by a part q of its unit:
//!
//! ```text
//! r(p) = sign(p) u (round(|p|/u - q) + q)     -1/2 < q < 1/2
//! r(p) = 0  for |p| < u/2                     r(p) = p  for whole |p|/u
//! ```
//!
//! The error of r is uniform in q, as that of the type is over its residues, and q = 0 is the type itself.
//! So the expected error is the median over q: [`PHASES`] values, evenly spread, none of which is zero.
//!
//! What the scene fixes is no guess and is rounded as the type rounds it: start values, gravity, lengths
//! to the nearest unit; coefficients to 31 bits, inverse masses to 26, spans to odd mantissas by turns.

use std::cell::Cell;

/// How many places of the grid are tried.
pub const PHASES: u32 = 8;

/// Where a grid lies. A unit of zero is none: numbers are as `f64` has them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    unit: f64,
    phase: f64,
    end: f64,
}

thread_local! {
    static GRID: Cell<Grid> = const { Cell::new(Grid::NONE) };
}

impl Grid {
    /// No rounding.
    pub const NONE: Grid = Grid {
        unit: 0.0,
        phase: 0.0,
        end: f64::INFINITY,
    };

    /// Place `i` of [`PHASES`] for a type with that many fractional bits.
    pub fn shifted(fraction: u32, i: u32) -> Grid {
        Grid {
            unit: (-f64::from(fraction)).exp2(),
            phase: (f64::from(i) + 0.5) / f64::from(PHASES) - 0.5,
            end: f64::from(31 - fraction as i32).exp2(),
        }
    }

    /// No rounding, but the range of a type with that many fractional bits.
    pub fn ending(fraction: u32) -> Grid {
        Grid {
            unit: 0.0,
            ..Grid::shifted(fraction, 0)
        }
    }

    /// Does `run` on this grid.
    pub fn during<R>(self, run: impl FnOnce() -> R) -> R {
        let before = GRID.replace(self);
        let result = run();
        GRID.set(before);
        result
    }
}

/// A result as the type holds it: it ends at the end of the range.
pub fn held(value: f64) -> f64 {
    let end = GRID.get().end;
    value.clamp(-end, end)
}

/// A sum of two products, which ends at `2^62` square units.
pub fn held_wide(sum: f64) -> f64 {
    let end = GRID.get().end;
    sum.clamp(-end * end, end * end)
}

/// A product, rounded.
pub fn product(value: f64) -> f64 {
    in_units(value, GRID.get().unit)
}

/// What has that many bits behind the point in every type.
pub fn fine(value: f64, fraction: u32) -> f64 {
    match GRID.get().unit {
        0.0 => value,
        _ => in_units(value, (-f64::from(fraction)).exp2()),
    }
}

fn in_units(value: f64, unit: f64) -> f64 {
    let phase = GRID.get().phase;
    if unit == 0.0 {
        return value;
    }
    let units = value.abs() / unit;
    if units < 0.5 {
        return 0.0;
    }
    if units.fract() == 0.0 {
        return value;
    }
    (((units - phase).round() + phase) * unit).copysign(value)
}

/// What a damped velocity loses of `value`: a unit where rounding leaves nothing.
pub fn loss(value: f64) -> f64 {
    let rounded = product(value);
    if rounded == 0.0 && value != 0.0 {
        return GRID.get().unit.copysign(value);
    }
    rounded
}

/// A constant, to the nearest unit.
pub fn constant(value: f64) -> f64 {
    match GRID.get().unit {
        0.0 => value,
        unit => (value / unit).round() * unit,
    }
}

/// The share of tick `tick` in a constant gain, by sums rounded once.
pub fn gained(gain: f64, tick: u64) -> f64 {
    let unit = GRID.get().unit;
    if unit == 0.0 {
        return gain;
    }
    let sum = |ticks: u64| (gain.abs() / unit * ticks as f64 + 0.5).floor();
    ((sum(tick + 1) - sum(tick)) * unit).copysign(gain)
}

/// To that many bits, nearest: `value` less the digits behind, by Veltkamp's splitting.
fn bits(value: f64, bits: u32) -> f64 {
    if GRID.get().unit == 0.0 {
        return value;
    }
    let scaled = value * ((1_u64 << (53 - bits)) + 1) as f64;
    scaled - (scaled - value)
}

/// A coefficient: 31 bits, none behind `2^-62`, and nothing from `2^30` on.
pub fn coefficient(value: f64) -> f64 {
    const LAST: f64 = (1_u64 << 62) as f64;
    const LIMIT: f64 = (1_u64 << 30) as f64;
    if GRID.get().unit == 0.0 {
        return value;
    }
    let value = bits(value, 31).clamp(-LIMIT, LIMIT);
    (value * LAST).round() / LAST
}

/// An inverse mass: 26 bits.
pub fn inverse_mass(value: f64) -> f64 {
    bits(value, 26)
}

/// The odd mantissas of 31 bits on either side of a length of time.
pub fn spans(seconds: f64) -> [f64; 2] {
    if GRID.get().unit == 0.0 {
        return [seconds; 2];
    }
    let scale = (30.0 - seconds.log2().floor()).exp2();
    let floor = (seconds * scale).floor();
    let below = if floor % 2.0 == 0.0 {
        floor - 1.0
    } else {
        floor
    };
    [below / scale, (below + 2.0) / scale]
}
