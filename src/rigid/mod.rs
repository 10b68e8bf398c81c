//! Rung two: bodies that rotate.
//!
//! ```text
//! x' = x + h v      v' = v + J / m          J an impulse, r where it acts, from the centre of mass
//! θ' = θ + h s      s' = s + r×J / (2π I)   s in turns/s; r×J = r.x J.y - r.y J.x
//! ```
//!
//! A [`Rigid`] has a body of rung one as its centre of mass, and a [rotor]. It implements [`Body`] as its centre does, so
//! worlds, methods and forces of rung one move it as they move points. [`Rotating`] adds rotation, and [`torque`] has the
//! forces that rotate a body.
//!
//! Source: Hecker, "Physics, Part 2: Angular Effects" (Game Developer, 1996).

mod angle;
pub mod carried_rotor;
mod centre;
mod rotating;
pub mod rotor;
mod saved;
mod state;
pub mod torque;

use crate::body::{Body, Carried, Point, finite};
use crate::error::Error;
use crate::mass::MassProperties;
use crate::ratio::Ratio;
use crate::scalar::{Angular, CarryAngular, Factor, Scalar};
use crate::vec2::Vec2;

pub use angle::{Angle, Rotation};
pub use carried_rotor::CarriedRotor;
pub use centre::Centre;
pub use rotating::Rotating;
pub use rotor::{PlainRotor, Rotor};
pub use saved::SavedRotor;

/// What moves a body.
///
/// ```
/// use fixstep::{Kind, prelude::*};
/// assert_eq!(Rigid::new(Point::<f32>::new(vec2(0, 0)?, vec2(0, 0)?, 1)?, 1)?.kind(), Kind::Dynamic);
/// assert_eq!(Rigid::<Point<f32>>::kinematic(vec2(0, 0)?, vec2(1, 0)?)?.kind(), Kind::Kinematic);
/// assert_eq!(Rigid::<Point<f32>>::static_at(vec2(0, 0)?)?.kind(), Kind::Static);
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Forces do.
    Dynamic,
    /// Its own velocity and spin, which no force changes.
    Kinematic,
    /// Nothing: a kinematic body at rest.
    Static,
}

/// A rigid body: `Rigid<Point<S>>` of 36 bytes in 32-bit fixed point (32 in `f32`), or `Rigid<Carried<S>>`, which keeps
/// what its roundings leave over, of 56.
///
/// ```
/// use fixstep::{dec, vec2, Angle, Point, Rigid, SemiImplicitEuler, Step, World, fixed::types::I16F16};
/// // A rod of 2 kg and 1.2 m: inertia m l² / 12.
/// let centre = Point::<I16F16>::new(vec2(0, 5)?, vec2(1, 0)?, 2)?;
/// let rod = Rigid::new(centre, dec!(0.24))?.with_angle(Angle::degrees(30)).with_spin(dec!(0.5))?;
/// let mut world = World::<_, 4>::new();
/// let id = world.add(rod)?;
/// for _ in 0..60 {
///     world.step(&mut SemiImplicitEuler, &mut (), &Step::hz(60)?);
/// }
/// let turned = world.get(id)?.angle() - Angle::degrees(30);
/// assert!((turned.to_f64().abs() - 0.5).abs() < 1e-7); // half a turn
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rigid<C: Centre> {
    centre: C,
    rotor: C::Rotor,
}

/// `2π`, to 62 bits.
const TAU: (i64, u64) = (3_622_009_729_038_561_421, 1 << 59);

impl<C: Centre> Rigid<C> {
    /// A body with `inertia`, its moment of inertia about `centre`, kg m²; at angle zero and without spin.
    ///
    /// Refuses an inertia that is not positive, or whose inverse cannot be held (32-bit fixed point: below
    /// 1.5e-10 or above 6.8e8 kg m²; floats: above 7.3e17).
    #[inline]
    pub fn new(centre: C, inertia: impl Into<Ratio>) -> Result<Rigid<C>, Error> {
        let (field, value) = ("inertia", inertia.into());
        let inverse = value.inverse().ok_or(Error::NotPositive { field, value })?;
        let error = Error::OutOfRange { field, value };
        let tau = Ratio::new(TAU.0, TAU.1).map_err(|_| error)?;
        let per_turn = inverse.over(tau).filter(|ratio| ratio.num() != 0);
        let inv_inertia = per_turn.and_then(Factor::new).ok_or(error)?;
        Ok(Self::with_inv_inertia(centre, inv_inertia))
    }

    /// The body that has these mass properties, with its centre where theirs is: a
    /// [`shape`](crate::mass), or what is made of several. Refuses what [`Point::new`] and [`Rigid::new`] refuse.
    ///
    /// ```
    /// use fixstep::{dec, mass, vec2, Point, Rigid};
    /// let plate = mass::rectangle::<f32>(1, dec!(0.5))?.with_density(10)?;
    /// let body = Rigid::<Point<_>>::from_properties(&plate.at(vec2(3, 4)?)?, vec2(0, 0)?)?;
    /// assert_eq!(body.position(), vec2(3, 4)?);
    /// # Ok::<(), fixstep::Error>(())
    /// ```
    pub fn from_properties(
        properties: &MassProperties<C::S>,
        velocity: Vec2<C::S>,
    ) -> Result<Rigid<C>, Error> {
        let centre = Point::new(properties.centre(), velocity, properties.mass())?;
        Rigid::new(centre.into(), properties.inertia())
    }

    /// A body that forces move but no torque rotates: it keeps the spin it is given, zero at first.
    #[inline]
    #[must_use]
    pub fn locked(centre: C) -> Rigid<C> {
        Self::with_inv_inertia(centre, C::S::ZERO.coef())
    }

    /// A body that moves with `velocity` (m/s), and with the spin it is given, whatever forces act. Refuses
    /// NaN and infinity.
    #[inline]
    pub fn kinematic(position: Vec2<C::S>, velocity: Vec2<C::S>) -> Result<Rigid<C>, Error> {
        C::kinematic(position, velocity).map(Self::locked)
    }

    /// A static body: one that stays where it is. Refuses NaN and infinity.
    #[inline]
    pub fn static_at(position: Vec2<C::S>) -> Result<Rigid<C>, Error> {
        Self::kinematic(position, Vec2::ZERO)
    }

    #[inline]
    fn with_inv_inertia(centre: C, inv_inertia: <C::S as Scalar>::Coef) -> Rigid<C> {
        let rotor = C::Rotor::new(inv_inertia);
        Rigid { centre, rotor }
    }

    /// The same body at another angle.
    #[inline]
    #[must_use]
    pub fn with_angle(mut self, angle: Angle<C::S>) -> Rigid<C> {
        self.rotor.set_angle(angle);
        self
    }

    /// The same body with a spin, turns/s. Refuses a value outside the range.
    #[inline]
    pub fn with_spin(mut self, spin: impl Into<Ratio>) -> Result<Rigid<C>, Error> {
        let (field, value) = ("spin", spin.into());
        let spin = C::S::ratio(value).ok_or(Error::OutOfRange { field, value })?;
        self.rotor.set_spin(spin);
        Ok(self)
    }

    /// What moves it.
    #[must_use]
    pub fn kind(&self) -> Kind {
        let at_rest = self.velocity() == Vec2::ZERO && self.spin() == C::S::ZERO;
        match (self.has_infinite_mass(), at_rest) {
            (false, _) => Kind::Dynamic,
            (true, false) => Kind::Kinematic,
            (true, true) => Kind::Static,
        }
    }

    /// Position of the centre of mass, m.
    #[inline]
    #[must_use]
    pub fn position(&self) -> Vec2<C::S> {
        self.centre.position()
    }

    /// Velocity of the centre of mass, m/s.
    #[inline]
    #[must_use]
    pub fn velocity(&self) -> Vec2<C::S> {
        self.centre.velocity()
    }

    /// Its angle.
    #[inline]
    #[must_use]
    pub fn angle(&self) -> Angle<C::S> {
        self.rotor.angle()
    }

    /// Its spin, turns/s.
    #[inline]
    #[must_use]
    pub fn spin(&self) -> C::S {
        self.rotor.spin()
    }

    /// Puts the body elsewhere; its velocity stays. Refuses NaN and infinity.
    pub fn teleport(&mut self, position: Vec2<C::S>) -> Result<(), Error> {
        self.centre.teleport(position)
    }

    /// Gives it another velocity: the way to drive a kinematic body. Refuses NaN and infinity.
    pub fn set_velocity(&mut self, velocity: Vec2<C::S>) -> Result<(), Error> {
        self.centre.set_velocity(velocity)
    }

    /// Sets it at another angle; its spin stays.
    pub fn set_angle(&mut self, angle: Angle<C::S>) {
        self.rotor.set_angle(angle);
    }

    /// Gives it another spin, turns/s. Refuses NaN and infinity.
    pub fn set_spin(&mut self, spin: C::S) -> Result<(), Error> {
        finite("spin", Vec2::new(spin, C::S::ZERO))?;
        self.rotor.set_spin(spin);
        Ok(())
    }
}

impl<S: CarryAngular> Rigid<Carried<S>> {
    /// Momentum with its remainder, kg m/s, as [`Carried::momentum`]; none of a body that no force moves.
    ///
    /// ```
    /// use fixstep::{dec, vec2, Body, Carried, Rigid, Vec2, fixed::types::I16F16};
    /// let centre = Carried::<I16F16>::new(vec2(0, 0)?, vec2(0, 0)?, 3)?;
    /// let mut body = Rigid::new(centre, 1)?;
    /// body.push(vec2(dec!(0.5), 0)?); // a sixth of a metre a second, which no number of units is
    /// assert_eq!(body.momentum(), Vec2::new(0.5, 0.0));
    /// let mut wall = Rigid::<Carried<I16F16>>::kinematic(vec2(0, 0)?, vec2(1, 0)?)?;
    /// wall.push(vec2(1, 1)?);
    /// assert_eq!(wall.momentum(), Vec2::ZERO);
    /// # Ok::<(), fixstep::Error>(())
    /// ```
    #[must_use]
    pub fn momentum(&self) -> Vec2<f64> {
        match self.has_infinite_mass() {
            true => Vec2::ZERO,
            false => self.centre.momentum(),
        }
    }
}

/// A body whose spin no torque changes: [`Rigid::locked`].
impl<S: Angular> From<Point<S>> for Rigid<Point<S>> {
    #[inline]
    fn from(point: Point<S>) -> Self {
        Rigid::locked(point)
    }
}
