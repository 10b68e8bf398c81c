//! The body of rung one: a point with mass.

use crate::body::{Body, NoSpin, Reverse, finite};
use crate::error::Error;
use crate::ratio::Ratio;
use crate::scalar::{Exact, Factor, Scalar};
use crate::time::TimeStep;
use crate::vec2::Vec2;

/// A point with mass in 20 bytes of any 32-bit scalar: position, velocity, inverse mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point<S: Scalar> {
    position: Vec2<S>,
    velocity: Vec2<S>,
    inv_mass: S::InvMass,
}

impl<S: Scalar> Point<S> {
    /// A point at `position` (m) with `velocity` (m/s) and `mass` (kg).
    ///
    /// Refuses a mass that is not positive or whose inverse the scalar cannot hold (32-bit fixed
    /// point: from 0.5 g to 2000 t), and a state that is NaN or infinite.
    ///
    /// ```
    /// use fixstep::{dec, vec2, Point, fixed::types::I16F16};
    /// let ball = Point::<I16F16>::new(vec2(0, 10)?, vec2(3, 0)?, dec!(0.5))?;
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

    /// From a state that was a point's before, NaN and all; `None` where the inverse mass is not
    /// finite or not greater than zero, as only the bits of a float can be.
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

    /// The same with another inverse mass, which nothing checks.
    pub(crate) const fn with_inv_mass(self, inv_mass: S::InvMass) -> Self {
        Point { inv_mass, ..self }
    }

    /// Puts the point elsewhere; its velocity stays. Refuses NaN and infinity.
    pub fn teleport(&mut self, position: Vec2<S>) -> Result<(), Error> {
        finite("position", position)?;
        self.position = position;
        Ok(())
    }

    /// Gives the point another velocity. Refuses NaN and infinity.
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
