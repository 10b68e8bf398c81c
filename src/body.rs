//! A body of rung one: a point with mass.

use crate::error::Error;
use crate::ratio::Ratio;
use crate::scalar::{Exact, Factor, Scalar};
use crate::step::TimeStep;
use crate::vec2::Vec2;

/// What the stages ask of a body. A body that keeps the remainders of its roundings implements
/// the same verbs and takes part in every scene.
pub trait Body: Copy + 'static {
    /// Its number type.
    type S: Scalar;

    /// Position of the centre of mass, m.
    #[must_use]
    fn position(&self) -> Vec2<Self::S>;

    /// Velocity of the centre of mass, m/s.
    #[must_use]
    fn velocity(&self) -> Vec2<Self::S>;

    /// One over its mass, 1/kg.
    #[must_use]
    fn inv_mass(&self) -> <Self::S as Scalar>::InvMass;

    /// `v += dv`: a change of velocity that is the same for every mass, m/s.
    fn kick(&mut self, dv: Vec2<Self::S>);

    /// `v.y += dv`: a [`kick`](Body::kick) along y alone.
    #[inline]
    fn kick_y(&mut self, dv: Self::S) {
        self.kick(Vec2::new(Self::S::ZERO, dv));
    }

    /// `v += factor * value`, for a product that is not rounded yet: a body that keeps remainders
    /// keeps this one.
    #[inline]
    fn kick_by(&mut self, value: Vec2<Self::S>, factor: <Self::S as Scalar>::Coef) {
        self.kick(value.scaled(factor));
    }

    /// `v -= factor * value`, as [`kick_by`](Body::kick_by).
    #[inline]
    fn brake_by(&mut self, value: Vec2<Self::S>, factor: <Self::S as Scalar>::Coef) {
        self.kick(-value.scaled(factor));
    }

    /// `v += impulse / m`, kg m/s.
    fn push(&mut self, impulse: Vec2<Self::S>);

    /// `v -= loss * v`, towards rest and never past it, for a loss from 0 to 1. In fixed point each
    /// part of v that is not zero loses a unit or more, so that it comes to rest.
    #[inline]
    fn damp(&mut self, loss: <Self::S as Scalar>::Coef) {
        self.kick(-self.velocity().map(|v| v.lost(loss)));
    }

    /// `v = 0`, with all that was left over.
    #[inline]
    fn halt(&mut self) {
        self.kick(-self.velocity());
    }

    /// `v += factor * (x - from)`; a body that keeps remainders counts them in.
    #[inline]
    fn kick_from(&mut self, from: Vec2<Self::S>, factor: <Self::S as Scalar>::Coef) {
        self.kick_by(self.position() - from, factor);
    }

    /// `x += dx`, m.
    fn shift(&mut self, dx: Vec2<Self::S>);

    /// `x += factor * value`, for a product that is not rounded yet.
    #[inline]
    fn move_by(&mut self, value: Vec2<Self::S>, factor: <Self::S as Scalar>::Coef) {
        self.shift(value.scaled(factor));
    }

    /// `x += h v`.
    fn drift(&mut self, step: &impl TimeStep<Self::S>);

    /// `x += h/2 v`.
    fn drift_half(&mut self, step: &impl TimeStep<Self::S>);

    /// `x += factor v`, for a part of a step; a body that keeps remainders moves by all of v.
    #[inline]
    fn drift_by(&mut self, factor: <Self::S as Scalar>::Coef) {
        self.move_by(self.velocity(), factor);
    }

    /// `x += a z + b v` and `v += c z + d v` by the state before, with `z = x - from` and `by` the four
    /// in that order; a body that keeps remainders counts them in.
    #[inline]
    fn swing(&mut self, from: Vec2<Self::S>, by: [<Self::S as Scalar>::Coef; 4]) {
        let ([a, b, c, d], z, v) = (by, self.position() - from, self.velocity());
        self.move_by(z, a);
        self.move_by(v, b);
        self.kick_by(z, c);
        self.kick_by(v, d);
    }

    /// Half a turn: `x` to the other side of `about`, and `v = -v`.
    #[inline]
    fn mirror(&mut self, about: Vec2<Self::S>) {
        let (z, v) = (self.position() - about, self.velocity());
        self.shift(-z);
        self.shift(-z);
        self.kick(-v);
        self.kick(-v);
    }

    /// Hands the exact bits of its state to `write`, for a hash. A body that holds more than
    /// position and velocity adds it.
    fn write_state(&self, write: &mut impl FnMut(u64)) {
        let (position, velocity) = (self.position().array(), self.velocity().array());
        position
            .into_iter()
            .chain(velocity)
            .for_each(|scalar| write(scalar.bits()));
    }

    /// Whether every part of its state is away from the ends of the range and finite.
    #[must_use]
    fn is_inside(&self) -> bool {
        self.position().is_inside() && self.velocity().is_inside()
    }
}

/// A body that can go the way it came: its verbs add without loss, and it can be turned round.
///
/// That is the law for a body of your own: a verb with the negated argument undoes the verb, unless a sum
/// saturated; turned round, [`drift`](Body::drift) undoes itself.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot go back: its sums lose bits",
    note = "a point in fixed point can: `Watched<Point<I16F16>>`"
)]
pub trait Turn: Body {
    /// `v = -v`.
    fn turn(&mut self);
}

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
        let finite = inv_mass.of(S::ZERO) == S::ZERO;
        (finite && inv_mass.of(S::MAX) > S::ZERO).then_some(Point {
            position,
            velocity,
            inv_mass,
        })
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

/// A finite number less itself is zero; infinity and NaN give NaN.
#[inline]
pub(crate) fn finite<S: Scalar>(field: &'static str, v: Vec2<S>) -> Result<(), Error> {
    if v.map(|s| s.minus(s)) == Vec2::ZERO {
        Ok(())
    } else {
        Err(Error::NotFinite { field })
    }
}

impl<S: Scalar> Body for Point<S> {
    type S = S;

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
        self.position += self.velocity.map(|v| step.of(v));
    }

    #[inline]
    fn drift_half(&mut self, step: &impl TimeStep<S>) {
        self.position += self.velocity.map(|v| step.half_of(v));
    }
}

impl<S: Exact> Turn for Point<S> {
    #[inline]
    fn turn(&mut self) {
        self.velocity = -self.velocity;
    }
}
