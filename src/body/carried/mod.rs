//! A body that keeps what its roundings leave over.

mod verbs;

use super::{Body, Point};
use crate::error::Error;
use crate::ratio::Ratio;
use crate::scalar::Carry;
use crate::vec2::Vec2;

/// A point with mass that adds up what every drift and kick rounds away: 32 bytes in a 32-bit scalar,
/// where [`Point`] has 20.
///
/// | kept | not kept |
/// |---|---|
/// | drifts of every method, and [`ExactSpring`](crate::ExactSpring) | what a pair sees of the other: its rounded state |
/// | kicks of gravity, drags, anchors, functions, pulls | each k of `Rk4`: a force below a quarter unit of velocity a step does nothing there |
/// | pushes: in units of momentum | `Pull`, and any force under `Rk4`: kicks, by which momentum walks |
///
/// Use it where a run is long: in fixed point at a dyadic rate a cruise is exact for ever, at 60 Hz to the last digit of
/// `h`; a body under drag comes to rest where it should; and the momentum of bodies that push each other, counted with
/// remainders by [`momentum`](Carried::momentum), is constant to the bit (up to `2^15` kg; a heavier body rounds an
/// impulse to its own unit). All but an exact spring see positions and velocities rounded, as a [`Point`] has them.
///
/// Positions are rounded for them away from zero where two are equally near: at a dyadic rate a scene that
/// is shifted over the origin is the same but for such ties.
///
/// ```
/// use fixstep::{dec, vec2, Carried, SemiImplicitEuler, Step, World, fixed::types::I16F16};
/// let mut world = World::<Carried<I16F16>, 1>::new();
/// let id = world.add(Carried::new(vec2(0, 0)?, vec2(dec!(0.001), 0)?, 1)?)?;
/// for _ in 0..60_000 {
///     world.step(&mut SemiImplicitEuler, &mut (), &Step::hz(60)?);
/// }
/// // A speed of 66 units: a point would drift at 60 of them.
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
    /// A point at `position` (m) with `velocity` (m/s) and `mass` (kg). Refuses what
    /// [`Point::new`] refuses.
    #[inline]
    pub fn new(
        position: Vec2<S>,
        velocity: Vec2<S>,
        mass: impl Into<Ratio>,
    ) -> Result<Carried<S>, Error> {
        Ok(Point::new(position, velocity, mass)?.into())
    }

    /// Position, m, rounded.
    #[inline]
    #[must_use]
    pub fn position(&self) -> Vec2<S> {
        let [x, y] = self.position;
        Vec2::new(S::seen(x), S::seen(y))
    }

    /// Velocity, m/s, rounded.
    #[inline]
    #[must_use]
    pub const fn velocity(&self) -> Vec2<S> {
        self.velocity
    }

    /// Momentum with its remainder, kg m/s; for reports. Exact in fixed point, so that sums of it can be
    /// compared to the bit.
    #[must_use]
    pub fn momentum(&self) -> Vec2<f64> {
        let [x, y] = self.kept().map(|kept| S::momentum(kept, self.inv_mass));
        Vec2::new(x, y)
    }

    /// Its position with what is left over, part by part.
    pub(crate) const fn fine_position(&self) -> [S::FinePosition; 2] {
        self.position
    }

    /// What is left over of its velocity.
    pub(crate) const fn remainder(&self) -> [S::Remainder; 2] {
        self.remainder
    }

    /// From a state that was one before, as [`Point::from_parts`].
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

    /// The same with another inverse mass, which nothing checks.
    pub(crate) const fn with_inv_mass(self, inv_mass: S::InvMass) -> Self {
        Carried { inv_mass, ..self }
    }

    /// Puts the point elsewhere; its velocity stays. Refuses NaN and infinity.
    pub fn teleport(&mut self, position: Vec2<S>) -> Result<(), Error> {
        super::finite("position", position)?;
        self.position = position.array().map(S::fine_position);
        Ok(())
    }

    /// Gives the point another velocity. Refuses NaN and infinity.
    pub fn set_velocity(&mut self, velocity: Vec2<S>) -> Result<(), Error> {
        super::finite("velocity", velocity)?;
        self.set([(velocity.x, S::NO_REMAINDER), (velocity.y, S::NO_REMAINDER)]);
        Ok(())
    }

    /// Both parts of the velocity with their remainders.
    #[inline]
    fn kept(&self) -> [(S, S::Remainder); 2] {
        let [remainder_x, remainder_y] = self.remainder;
        [
            (self.velocity.x, remainder_x),
            (self.velocity.y, remainder_y),
        ]
    }

    /// Both parts of how far it is from a point, with their remainders.
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

/// With nothing left over yet.
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
