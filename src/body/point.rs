//! A point with mass.

use crate::body::{Body, NoSpin, Reverse, finite};
use crate::error::Error;
use crate::ratio::Ratio;
use crate::scalar::{Exact, Factor, Scalar};
use crate::time::TimeStep;
use crate::vec2::Vec2;

/// A point with mass: position, velocity and inverse mass. In a 32-bit scalar it has 20 bytes.
///
/// ```
/// use fixstep::{Point, vec2};
/// let ball = Point::<f32>::new(vec2(0, 10)?, vec2(3, 0)?, 1)?;
/// assert_eq!(ball.position(), vec2(0, 10)?);
/// assert_eq!(size_of_val(&ball), 20);
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point<S: Scalar> {
    position: Vec2<S>,
    velocity: Vec2<S>,
    inv_mass: S::InvMass,
}

impl<S: Scalar> Point<S> {
    /// A point at `position` (m) with `velocity` (m/s) and `mass` (kg).
    ///
    /// The mass must be positive, and the scalar must hold its inverse: in 32-bit fixed point from 0.5 g
    /// to 2000 t. NaN and infinity in position or velocity are errors.
    ///
    /// ```
    /// use fixstep::{dec, vec2, Point, fixed::types::I16F16};
    /// let ball = Point::<I16F16>::new(vec2(0, 10)?, vec2(3, 0)?, dec!(0.5))?;
    /// assert_eq!(ball.velocity(), vec2(3, 0)?);
    /// assert!(Point::<f32>::new(vec2(0, 0)?, vec2(0, 0)?, 0).is_err());
    /// # Ok::<(), fixstep::Error>(())
    /// ```
    #[inline]
    pub fn new(
        position: Vec2<S>,
        velocity: Vec2<S>,
        mass: impl Into<Ratio>,
    ) -> Result<Point<S>, Error> {
        let (field, value) = ("mass", mass.into());
        let inverse = value.inverse().ok_or(Error::NotPositive { field, value })?;
        let inv_mass = S::InvMass::new(inverse).ok_or(Error::OutOfRange { field, value })?;
        finite("position", position)?;
        finite("velocity", velocity)?;
        Ok(Point {
            position,
            velocity,
            inv_mass,
        })
    }

    /// Position, m.
    #[inline]
    #[must_use]
    pub const fn position(&self) -> Vec2<S> {
        self.position
    }

    /// Velocity, m/s.
    #[inline]
    #[must_use]
    pub const fn velocity(&self) -> Vec2<S> {
        self.velocity
    }

    /// From the saved state of a point, which may contain NaN. `None` if the inverse mass is not finite or
    /// not greater than zero; only a float can have such bits.
    pub(crate) fn from_parts(
        position: Vec2<S>,
        velocity: Vec2<S>,
        inv_mass: S::InvMass,
    ) -> Option<Self> {
        let finite = inv_mass.scale(S::ZERO) == S::ZERO;
        (finite && inv_mass.scale(S::MAX) > S::ZERO).then_some(Point {
            position,
            velocity,
            inv_mass,
        })
    }

    /// The same point with another inverse mass, unchecked.
    pub(crate) const fn with_inv_mass(self, inv_mass: S::InvMass) -> Self {
        Point { inv_mass, ..self }
    }

    /// Sets the position and keeps the velocity. NaN and infinity are errors.
    ///
    /// ```
    /// # use fixstep::{Point, vec2};
    /// let mut ball = Point::<f32>::new(vec2(0, 10)?, vec2(3, 0)?, 1)?;
    /// ball.teleport(vec2(5, 5)?)?;
    /// assert_eq!((ball.position(), ball.velocity()), (vec2(5, 5)?, vec2(3, 0)?));
    /// # Ok::<(), fixstep::Error>(())
    /// ```
    pub fn teleport(&mut self, position: Vec2<S>) -> Result<(), Error> {
        finite("position", position)?;
        self.position = position;
        Ok(())
    }

    /// Sets the velocity and keeps the position. NaN and infinity are errors.
    ///
    /// ```
    /// # use fixstep::{Point, vec2};
    /// let mut ball = Point::<f32>::new(vec2(0, 10)?, vec2(3, 0)?, 1)?;
    /// ball.set_velocity(vec2(0, 4)?)?;
    /// assert_eq!((ball.position(), ball.velocity()), (vec2(0, 10)?, vec2(0, 4)?));
    /// # Ok::<(), fixstep::Error>(())
    /// ```
    pub fn set_velocity(&mut self, velocity: Vec2<S>) -> Result<(), Error> {
        finite("velocity", velocity)?;
        self.velocity = velocity;
        Ok(())
    }
}

impl<S: Scalar> Body for Point<S> {
    type S = S;
    type Spin = NoSpin;

    #[inline]
    fn position(&self) -> Vec2<S> {
        self.position
    }

    #[inline]
    fn velocity(&self) -> Vec2<S> {
        self.velocity
    }

    #[inline]
    fn inv_mass(&self) -> S::InvMass {
        self.inv_mass
    }

    #[inline]
    fn kick(&mut self, dv: Vec2<S>) {
        self.velocity += dv;
    }

    #[inline]
    fn kick_y(&mut self, dv: S) {
        self.velocity.y = self.velocity.y.plus(dv);
    }

    #[inline]
    fn brake_by(&mut self, value: Vec2<S>, factor: S::Coef) {
        self.velocity -= value.scaled(factor);
    }

    fn push(&mut self, impulse: Vec2<S>) {
        self.velocity += impulse.scaled(self.inv_mass);
    }

    #[inline]
    fn shift(&mut self, dx: Vec2<S>) {
        self.position += dx;
    }

    #[inline]
    fn drift(&mut self, step: &impl TimeStep<S>) {
        self.position += self.velocity.map(|v| step.times(v));
    }

    #[inline]
    fn drift_half(&mut self, step: &impl TimeStep<S>) {
        self.position += self.velocity.map(|v| step.half_times(v));
    }
}

impl<S: Exact> Reverse for Point<S> {
    #[inline]
    fn reverse(&mut self) {
        self.velocity = -self.velocity;
    }
}
