//! Angles, and the rotation of vectors by them.

use crate::ratio::Ratio;
use crate::scalar::{Angular, Turns};
use crate::time::Between;
use crate::vec2::Vec2;

/// An angle: a fraction of a turn that uses all bits of an integer, `2^-32` turns beside a 32-bit scalar.
/// It wraps exactly at a whole turn, and keeps its resolution after any number of turns.
///
/// Positive angles rotate from x to y: counter-clockwise with x to the right and y up.
///
/// ```
/// use fixstep::{dec, vec2, Angle, fixed::types::I16F16};
/// let quarter = Angle::<I16F16>::turns(dec!(0.25));
/// assert_eq!(quarter + quarter + quarter + quarter, Angle::ZERO);
/// assert_eq!(quarter, Angle::degrees(90));
/// assert_eq!(quarter.rotation().rotate(vec2(3, 1)?), vec2(-1, 3)?);
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Angle<S: Angular>(S::Turns);

impl<S: Angular> Angle<S> {
    /// No angle.
    pub const ZERO: Angle<S> = Angle(S::Turns::ZERO);

    /// The angle nearest to `turns`, without whole turns.
    #[inline(always)]
    #[must_use]
    pub fn turns(turns: impl Into<Ratio>) -> Angle<S> {
        Angle(S::Turns::nearest(turns.into()))
    }

    /// The angle nearest to `degrees`, a 360th of a turn each.
    #[inline(always)]
    #[must_use]
    pub fn degrees(degrees: impl Into<Ratio>) -> Angle<S> {
        let turns = degrees.into().per(Ratio::whole(360));
        turns.map_or(Angle::ZERO, Angle::turns)
    }

    /// The count that it is, in parts of a turn.
    #[inline]
    #[must_use]
    pub const fn count(self) -> S::Turns {
        self.0
    }

    /// The angle of that count.
    #[inline]
    #[must_use]
    pub const fn from_count(count: S::Turns) -> Angle<S> {
        Angle(count)
    }

    /// Turns from -1/2 to 1/2, for reports.
    #[must_use]
    pub fn to_f64(self) -> f64 {
        self.0.to_f64()
    }

    /// The angle to draw between this one and the one a step later. It takes the shorter way, so it is right for
    /// bodies that rotate less than half a turn a step.
    #[inline]
    #[must_use]
    pub fn between(self, after: Angle<S>, part: &Between<S>) -> Angle<S> {
        self + Angle(S::part_of((after - self).0, part.part()))
    }

    /// Its cosine and sine, computed once for all vectors to rotate by it.
    #[inline]
    #[must_use]
    pub fn rotation(self) -> Rotation<S> {
        Rotation(S::circle(self.0))
    }
}

impl<S: Angular> core::ops::Add for Angle<S> {
    type Output = Angle<S>;

    #[inline]
    fn add(self, other: Angle<S>) -> Angle<S> {
        Angle(self.0.plus(other.0))
    }
}

impl<S: Angular> core::ops::Neg for Angle<S> {
    type Output = Angle<S>;

    #[inline]
    fn neg(self) -> Angle<S> {
        Angle(self.0.negated())
    }
}

impl<S: Angular> core::ops::Sub for Angle<S> {
    type Output = Angle<S>;

    #[inline]
    fn sub(self, other: Angle<S>) -> Angle<S> {
        self + -other
    }
}

/// The cosine and the sine of an angle, to rotate vectors. In 32-bit fixed point each is off by at most a unit of
/// `2^-30`. In `f32` it is 33 of these units, half a unit of `f32` near 1. Lengths change by as little, and this error
/// never grows: no rotation is made from another.
///
/// ```
/// use fixstep::{fixed::types::I16F16, prelude::*};
/// let quarter = Angle::<I16F16>::degrees(90).rotation();
/// assert_eq!(quarter.rotate(vec2(3, 0)?), vec2(0, 3)?);
/// assert_eq!(quarter.rotate_back(vec2(0, 3)?), vec2(3, 0)?);
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotation<S: Angular>([S::Unit; 2]);

impl<S: Angular> Rotation<S> {
    /// `v` rotated: from the axes of a body to those of the world. Each part is rounded once.
    #[inline]
    #[must_use]
    pub fn rotate(self, v: Vec2<S>) -> Vec2<S> {
        let [x, y] = S::rotated(self.0, v.array());
        Vec2 { x, y }
    }

    /// `v` rotated back: from the axes of the world to those of a body.
    #[inline]
    #[must_use]
    pub fn rotate_back(self, v: Vec2<S>) -> Vec2<S> {
        let [cos, sin] = self.0;
        Rotation([cos, S::opposite(sin)]).rotate(v)
    }

    /// The cosine, rounded to the scalar.
    #[inline]
    #[must_use]
    pub fn cos(self) -> S {
        S::from_unit(self.0[0])
    }

    /// The sine, rounded to the scalar.
    #[inline]
    #[must_use]
    pub fn sin(self) -> S {
        S::from_unit(self.0[1])
    }
}
