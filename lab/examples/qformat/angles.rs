//! Angles of the number that takes notes: counts of `2^-64` turns, as those of `f64`. On a grid an angle moves
//! by whole units of `2^-32` turns, and a sine is one of `2^-30`, whatever the type.

use std::f64::consts::TAU;

use fixstep::{Angular, Scalar};

use crate::grid;
use crate::recorded::{Inverse, Rate, Recorded, product};

const TURNS: u32 = 32;
const UNIT: u32 = 30;

impl Angular for Recorded {
    type Turns = u64;
    type Unit = f64;

    const TAU: Rate = Rate(TAU);
    const INFINITE_MASS: Inverse = Inverse(0.0);

    fn advanced(angle: u64, spin: Recorded, h: Rate, halvings: u32) -> u64 {
        let turns = (h.0 * spin.0).dyadic(1, halvings);
        f64::advanced(angle, grid::fine(turns, TURNS), 1.0, 0)
    }

    fn advanced_dyadic(angle: u64, spin: Recorded, num: u32, shift: u32) -> u64 {
        let turns = spin.0.dyadic(num, shift);
        f64::advanced(angle, grid::fine(turns, TURNS), 1.0, 0)
    }

    fn part_of(angle: u64, part: Rate) -> u64 {
        f64::part_of(angle, part.0)
    }

    fn circle(angle: u64) -> [f64; 2] {
        f64::circle(angle).map(|part| grid::fine(part, UNIT))
    }

    fn rotated(circle: [f64; 2], v: [Recorded; 2]) -> [Recorded; 2] {
        f64::rotated(circle, v.map(|part| part.0)).map(product)
    }

    fn opposite(unit: f64) -> f64 {
        -unit
    }

    fn from_unit(unit: f64) -> Recorded {
        product(unit)
    }

    fn weighed(sum: f64, factor: Rate) -> Recorded {
        product(sum * factor.0)
    }
}
