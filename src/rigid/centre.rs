//! Bodies of rung one that can be the centre of mass of a rigid one.

use super::{CarriedRotor, PlainRotor, Rotor};
use crate::body::{Body, Carried, Point};
use crate::error::Error;
use crate::scalar::{Angular, CarryAngular, Scalar};
use crate::vec2::Vec2;

/// A body of rung one that can be the centre of mass of a rigid one.
///
/// ```
/// use fixstep::{Carried, Point, Rigid, fixed::types::I16F16};
/// // Both centres make rigid bodies; the second keeps what its roundings lose.
/// assert_eq!(size_of::<Rigid<Point<I16F16>>>(), 36);
/// assert_eq!(size_of::<Rigid<Carried<I16F16>>>(), 56);
/// ```
pub trait Centre: Body<S: Angular> + From<Point<<Self as Body>::S>> {
    /// How its body rotates.
    type Rotor: Rotor<Self::S>;

    /// One that no force moves. Refuses NaN and infinity.
    fn kinematic(position: Vec2<Self::S>, velocity: Vec2<Self::S>) -> Result<Self, Error>;

    /// The same with another inverse mass, which nothing checks; for what reads and writes bodies.
    #[must_use]
    fn with_inv_mass(self, inv_mass: <Self::S as Scalar>::InvMass) -> Self;

    /// Puts it elsewhere. Refuses NaN and infinity.
    fn teleport(&mut self, position: Vec2<Self::S>) -> Result<(), Error>;

    /// Gives it another velocity. Refuses NaN and infinity.
    fn set_velocity(&mut self, velocity: Vec2<Self::S>) -> Result<(), Error>;
}

macro_rules! centre {
    ($centre:ident<$scalar:ident>, $rotor:ident) => {
        impl<S: $scalar> Centre for $centre<S> {
            type Rotor = $rotor<S>;

            fn kinematic(position: Vec2<S>, velocity: Vec2<S>) -> Result<Self, Error> {
                let point = Point::new(position, velocity, 1)?;
                Ok($centre::from(point).with_inv_mass(S::INFINITE_MASS))
            }

            fn with_inv_mass(self, inv_mass: S::InvMass) -> Self {
                self.with_inv_mass(inv_mass)
            }

            fn teleport(&mut self, position: Vec2<S>) -> Result<(), Error> {
                $centre::teleport(self, position)
            }

            fn set_velocity(&mut self, velocity: Vec2<S>) -> Result<(), Error> {
                $centre::set_velocity(self, velocity)
            }
        }
    };
}

centre!(Point<Angular>, PlainRotor);
centre!(Carried<CarryAngular>, CarriedRotor);
