//! A *carried* body: it keeps what rounding loses.

mod verbs;

use super::{Body, Point};
use crate::error::Error;
use crate::ratio::Ratio;
use crate::scalar::Carry;
use crate::vec2::Vec2;

/// A point with mass that is *carried*: it keeps what every drift and kick loses by rounding.
///
/// It has 32 bytes in a 32-bit scalar; a [`Point`] has 20. Use it for long runs in fixed point:
///
/// * Motion without forces is exact for ever at a dyadic rate. At 60 Hz it is exact to the last digit of `h`.
/// * With drag a body comes to rest at the right position.
/// * Impulses between bodies keep the total of [`momentum`](Carried::momentum) constant to the bit. That
///   holds up to `2^15` kg; a heavier body rounds an impulse to its own unit.
///
/// | kept | not kept |
/// |---|---|
/// | drifts of every method, and [`ExactSpring`](crate::ExactSpring) | a pair force reads the rounded state of the other body |
/// | kicks of gravity, drags, anchors, functions, pulls | each k of `Rk4`: a force below a quarter unit of velocity a step does nothing there |
/// | impulses: in units of momentum | `Pull`, and any force with `Rk4`: these are kicks, and the total momentum does a random walk |
///
/// Only an exact spring reads the remainders. All other forces read positions and velocities rounded, as
/// those of a [`Point`]. A position half-way between two values rounds away from zero for them. At a
/// dyadic rate a scene that is shifted over the origin is the same except for such ties.
///
/// ```
/// use fixstep::{dec, vec2, Carried, SemiImplicitEuler, Step, World, fixed::types::I16F16};
/// let mut world = World::<Carried<I16F16>, 1>::new();
/// let id = world.add(Carried::new(vec2(0, 0)?, vec2(dec!(0.001), 0)?, 1)?)?;
/// for _ in 0..60_000 {
///     world.step(&mut SemiImplicitEuler, &mut (), &Step::hz(60)?);
/// }
/// // The speed is 66 units of 1/65536 m/s; a `Point` would move at 60 units.
/// let exact = 66.0 / 65536.0 * 1000.0;
/// assert!((world.get(id)?.position().x.to_num::<f64>() - exact).abs() < 1e-5);
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Carried<S: Carry> {
    position: [S::FinePosition; 2],
    velocity: Vec2<S>,
    inv_mass: S::InvMass,
    remainder: [S::Remainder; 2],
}

impl<S: Carry> Carried<S> {
    /// A point at `position` (m) with `velocity` (m/s) and `mass` (kg). The errors are those of
    /// [`Point::new`].
    #[inline]
    pub fn new(
        position: Vec2<S>,
        velocity: Vec2<S>,
        mass: impl Into<Ratio>,
    ) -> Result<Carried<S>, Error> {
        Ok(Point::new(position, velocity, mass)?.into())
    }

    /// Rounded position, m.
    #[inline]
    #[must_use]
    pub fn position(&self) -> Vec2<S> {
        let [x, y] = self.position;
        Vec2::new(S::seen(x), S::seen(y))
    }

    /// Rounded velocity, m/s.
    #[inline]
    #[must_use]
    pub const fn velocity(&self) -> Vec2<S> {
        self.velocity
    }

    /// Momentum with its remainder, kg m/s; for reports. It is exact in fixed point, so that sums can
    /// be compared to the bit.
    #[must_use]
    pub fn momentum(&self) -> Vec2<f64> {
        let [x, y] = self.kept().map(|kept| S::momentum(kept, self.inv_mass));
        Vec2::new(x, y)
    }

    /// Its position with remainders, per axis.
    pub(crate) const fn fine_position(&self) -> [S::FinePosition; 2] {
        self.position
    }

    /// The remainders of its velocity.
    pub(crate) const fn remainder(&self) -> [S::Remainder; 2] {
        self.remainder
    }

    /// From a saved state, like [`Point::from_parts`].
    pub(crate) fn from_parts(
        position: [S::FinePosition; 2],
        velocity: Vec2<S>,
        inv_mass: S::InvMass,
        remainder: [S::Remainder; 2],
    ) -> Option<Self> {
        let point = Point::from_parts(Vec2::ZERO, velocity, inv_mass)?;
        Some(Carried {
            position,
            remainder,
            ..point.into()
        })
    }

    /// The same body with another inverse mass, unchecked.
    pub(crate) const fn with_inv_mass(self, inv_mass: S::InvMass) -> Self {
        Carried { inv_mass, ..self }
    }

    /// Sets the position and keeps the velocity. NaN and infinity are errors.
    ///
    /// ```
    /// # use fixstep::{Carried, vec2};
    /// let mut ball = Carried::<f32>::new(vec2(0, 10)?, vec2(3, 0)?, 1)?;
    /// ball.teleport(vec2(5, 5)?)?;
    /// assert_eq!((ball.position(), ball.velocity()), (vec2(5, 5)?, vec2(3, 0)?));
    /// # Ok::<(), fixstep::Error>(())
    /// ```
    pub fn teleport(&mut self, position: Vec2<S>) -> Result<(), Error> {
        super::finite("position", position)?;
        self.position = position.array().map(S::fine_position);
        Ok(())
    }

    /// Sets the velocity and keeps the position. NaN and infinity are errors.
    ///
    /// ```
    /// # use fixstep::{Carried, vec2};
    /// let mut ball = Carried::<f32>::new(vec2(0, 10)?, vec2(3, 0)?, 1)?;
    /// ball.set_velocity(vec2(0, 4)?)?;
    /// assert_eq!((ball.position(), ball.velocity()), (vec2(0, 10)?, vec2(0, 4)?));
    /// # Ok::<(), fixstep::Error>(())
    /// ```
    pub fn set_velocity(&mut self, velocity: Vec2<S>) -> Result<(), Error> {
        super::finite("velocity", velocity)?;
        self.set([(velocity.x, S::NO_REMAINDER), (velocity.y, S::NO_REMAINDER)]);
        Ok(())
    }

    /// Both components of the velocity with their remainders.
    #[inline]
    fn kept(&self) -> [(S, S::Remainder); 2] {
        let [remainder_x, remainder_y] = self.remainder;
        [
            (self.velocity.x, remainder_x),
            (self.velocity.y, remainder_y),
        ]
    }

    /// Both components of `position - from`, with their remainders.
    #[inline]
    fn beyond(&self, from: Vec2<S>) -> [(S, S::Remainder); 2] {
        let [x, y] = self.position;
        [S::beyond(x, from.x), S::beyond(y, from.y)]
    }

    #[inline]
    fn set(&mut self, [(x, remainder_x), (y, remainder_y)]: [(S, S::Remainder); 2]) {
        self.velocity = Vec2::new(x, y);
        self.remainder = [remainder_x, remainder_y];
    }
}

/// With remainders of zero.
impl<S: Carry> From<Point<S>> for Carried<S> {
    #[inline]
    fn from(point: Point<S>) -> Carried<S> {
        Carried {
            position: point.position().array().map(S::fine_position),
            velocity: point.velocity(),
            inv_mass: point.inv_mass(),
            remainder: [S::NO_REMAINDER; 2],
        }
    }
}
