//! A pair of scalars. Its operators keep the [laws](crate::scalar) of [`Scalar`]: fixed point saturates.
//!
//! ```
//! use fixstep::{Scalar, Vec2, fixed::types::I16F16};
//! let far = Vec2::new(I16F16::MAX, I16F16::MAX);
//! assert_eq!(far + far, far);
//! ```

use core::ops::{Add, AddAssign, Neg, Sub, SubAssign};

use crate::error::Error;
use crate::ratio::Ratio;
use crate::scalar::{Factor, Scalar};

/// A 2D vector: x to the right and y up, unless the scene chooses other axes.
///
/// ```
/// use fixstep::{fixed::types::I16F16, vec2};
/// let a = vec2::<I16F16>(3, 4)?;
/// let b = vec2::<I16F16>(1, 0)?;
/// assert_eq!(a + b, vec2(4, 4)?);
/// assert_eq!(a.length(), 5);
/// assert_eq!(b.perp(), vec2(0, 1)?);
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct Vec2<S> {
    /// First component.
    pub x: S,
    /// Second component.
    pub y: S,
}

/// A vector from constants, each rounded once into the scalar.
///
/// Refuses a component outside the range of the scalar.
///
/// ```
/// use fixstep::{dec, vec2, fixed::types::I16F16};
/// let g = vec2::<I16F16>(0, dec!(-9.81))?;
/// assert!(vec2::<I16F16>(40_000, 0).is_err());
/// # Ok::<(), fixstep::Error>(())
/// ```
#[inline]
pub fn vec2<S: Scalar>(x: impl Into<Ratio>, y: impl Into<Ratio>) -> Result<Vec2<S>, Error> {
    let component = |field, value| S::ratio(value).ok_or(Error::OutOfRange { field, value });
    Ok(Vec2 {
        x: component("x", x.into())?,
        y: component("y", y.into())?,
    })
}

impl<S: Scalar> Vec2<S> {
    /// The zero vector.
    pub const ZERO: Vec2<S> = Vec2 {
        x: S::ZERO,
        y: S::ZERO,
    };

    /// A vector from its components.
    #[inline]
    #[must_use]
    pub const fn new(x: S, y: S) -> Vec2<S> {
        Vec2 { x, y }
    }

    /// The components as an array, x first.
    #[inline]
    #[must_use]
    pub fn array(self) -> [S; 2] {
        [self.x, self.y]
    }

    /// Applies `f` to each component.
    #[inline]
    #[must_use]
    pub fn map<T>(self, mut f: impl FnMut(S) -> T) -> Vec2<T> {
        Vec2 {
            x: f(self.x),
            y: f(self.y),
        }
    }

    /// `self * factor`, each component rounded once.
    #[inline]
    #[must_use]
    pub fn scaled(self, factor: impl Factor<S>) -> Vec2<S> {
        self.map(|s| factor.scale(s))
    }

    /// `self.x * other.x + self.y * other.y` in the wide type.
    #[inline]
    #[must_use]
    pub fn dot(self, other: Vec2<S>) -> S::Sum {
        S::dot(self.array(), other.array())
    }

    /// The vector rotated by a quarter turn from x to y: `(-y, x)`.
    #[inline]
    #[must_use]
    pub fn perp(self) -> Vec2<S> {
        Vec2::new(self.y.negated(), self.x)
    }

    /// The perpendicular dot product `self.x * other.y - self.y * other.x` in the wide type.
    #[inline]
    #[must_use]
    pub fn cross(self, other: Vec2<S>) -> S::Sum {
        self.perp().dot(other)
    }

    /// Euclidean length, saturating.
    #[inline]
    #[must_use]
    pub fn length(self) -> S {
        S::length(self.array())
    }

    /// The vector of length `length` in the direction of `self`. The caller passes the length of
    /// `self` as `own`. Zero for a zero vector.
    #[inline]
    #[must_use]
    pub fn with_length(self, length: S, own: S) -> Vec2<S> {
        self.map(|s| S::quotient(S::dot([s, S::ZERO], [length, S::ZERO]), own))
    }

    /// Whether both components are finite and not at an end of the range.
    #[inline]
    #[must_use]
    pub fn is_inside(self) -> bool {
        self.x.is_inside() && self.y.is_inside()
    }

    /// The same vector in `f64`, for reports.
    #[must_use]
    pub fn to_f64(self) -> Vec2<f64> {
        self.map(S::to_f64)
    }
}

impl<S: Scalar> Add for Vec2<S> {
    type Output = Vec2<S>;

    #[inline]
    fn add(self, other: Vec2<S>) -> Vec2<S> {
        Vec2 {
            x: self.x.plus(other.x),
            y: self.y.plus(other.y),
        }
    }
}

impl<S: Scalar> Sub for Vec2<S> {
    type Output = Vec2<S>;

    #[inline]
    fn sub(self, other: Vec2<S>) -> Vec2<S> {
        Vec2 {
            x: self.x.minus(other.x),
            y: self.y.minus(other.y),
        }
    }
}

impl<S: Scalar> Neg for Vec2<S> {
    type Output = Vec2<S>;

    #[inline]
    fn neg(self) -> Vec2<S> {
        self.map(S::negated)
    }
}

impl<S: Scalar> AddAssign for Vec2<S> {
    #[inline]
    fn add_assign(&mut self, other: Vec2<S>) {
        *self = *self + other;
    }
}

impl<S: Scalar> SubAssign for Vec2<S> {
    #[inline]
    fn sub_assign(&mut self, other: Vec2<S>) {
        *self = *self - other;
    }
}
