//! A point as C sees it: raw bits of `I16F16`.

use fixstep::fixed::types::I16F16;
use fixstep::{Error, Point, Ratio, Vec2};

/// Where a point is, m, and how it moves, m/s.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Body {
    pub x: i32,
    pub y: i32,
    pub vx: i32,
    pub vy: i32,
}

impl Body {
    pub(crate) fn of(point: &Point<I16F16>) -> Body {
        let [x, y] = point.position().array().map(I16F16::to_bits);
        let [vx, vy] = point.velocity().array().map(I16F16::to_bits);
        Body { x, y, vx, vy }
    }

    /// Position and velocity.
    pub(crate) fn parts(&self) -> (Vec2<I16F16>, Vec2<I16F16>) {
        (vector(self.x, self.y), vector(self.vx, self.vy))
    }
}

/// The number that C wrote as `bits`.
pub(crate) fn number(bits: i32) -> Result<Ratio, Error> {
    Ok(Ratio::new(bits.into(), 1 << 16)?)
}

/// The vector of these bits.
pub(crate) fn vector(x: i32, y: i32) -> Vec2<I16F16> {
    Vec2::new(I16F16::from_bits(x), I16F16::from_bits(y))
}
