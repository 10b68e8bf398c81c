//! The state of a rigid body, as a snapshot holds it.
//!
//! ```text
//! Rigid<C>        d   state of C   rotor          d is 1 for a kinematic body, else 0
//! PlainRotor      θ        s       1/2πI
//! CarriedRotor    θ θ      s       1/2πI    r     two halves of the angle, remainder of the spin
//! ```
//!
//! No centre is read with an inverse mass of zero. So a kinematic body is written with a mass of 1 kg. An inverse inertia
//! is written as the scalar stores a coefficient: in fixed point a mantissa of 4 bytes and a byte for its shift.
//!
//! Every value that is read is checked. An inverse inertia must be zero, or finite and positive. A kinematic body must
//! have an inverse inertia of zero and a mass of 1 kg.

use super::angle::Angle;
use super::carried_rotor::CarriedRotor;
use super::rotor::{PlainRotor, Rotor};
use super::{Centre, Rigid};
use crate::body::Body;
use crate::ratio::Ratio;
use crate::scalar::{Angular, CarryAngular, Factor, Scalar, Stored, Turns};
use crate::world::snapshot::Saved;

/// A rotor that a snapshot can hold.
///
/// ```
/// use fixstep::{fixed::types::I16F16, rigid::{CarriedRotor, PlainRotor, SavedRotor}};
/// assert_eq!(<PlainRotor<I16F16> as SavedRotor>::BYTES, 13);
/// assert_eq!(<CarriedRotor<I16F16> as SavedRotor>::BYTES, 19);
/// ```
pub trait SavedRotor: Sized {
    /// Bytes of its state: as many as `save` hands out and `load` takes.
    const BYTES: usize;

    /// Hands its state to `write`, as [`Saved::save`] does.
    fn save(&self, write: &mut impl FnMut(u64, usize));

    /// The rotor of the state that `read` gives; `None` where no rotor has it.
    #[must_use]
    fn load(read: &mut impl FnMut(usize) -> u64) -> Option<Self>;
}

impl<S: Angular<Coef: Stored> + Stored> SavedRotor for PlainRotor<S> {
    const BYTES: usize = size_of::<S::Turns>() + S::BYTES + <S::Coef as Stored>::BYTES;

    fn save(&self, write: &mut impl FnMut(u64, usize)) {
        write(self.angle().count().bits(), size_of::<S::Turns>());
        write(self.spin().store(), S::BYTES);
        write(self.inv_inertia().store(), <S::Coef as Stored>::BYTES);
    }

    fn load(read: &mut impl FnMut(usize) -> u64) -> Option<Self> {
        let angle = S::Turns::from_bits(read(size_of::<S::Turns>()))?;
        let spin = S::restore(read(S::BYTES))?;
        let inv_inertia = S::Coef::restore(read(<S::Coef as Stored>::BYTES))?;
        PlainRotor::from_parts(Angle::from_count(angle), spin, inv_inertia)
    }
}

impl<S: CarryAngular<Coef: Stored> + Stored> SavedRotor for CarriedRotor<S> {
    const BYTES: usize =
        2 * size_of::<S::Turns>() + S::BYTES + <S::Coef as Stored>::BYTES + S::REMAINDER_BYTES;

    fn save(&self, write: &mut impl FnMut(u64, usize)) {
        let (angle, rest) = self.parts();
        for half in S::fine_halves(angle) {
            write(half, size_of::<S::Turns>());
        }
        write(self.spin().store(), S::BYTES);
        write(self.inv_inertia().store(), <S::Coef as Stored>::BYTES);
        write(S::remainder_bits(rest), S::REMAINDER_BYTES);
    }

    fn load(read: &mut impl FnMut(usize) -> u64) -> Option<Self> {
        let mut half = || read(size_of::<S::Turns>());
        let angle = S::from_fine_halves([half(), half()])?;
        let spin = S::restore(read(S::BYTES))?;
        let inv_inertia = S::Coef::restore(read(<S::Coef as Stored>::BYTES))?;
        let rest = S::from_remainder_bits(read(S::REMAINDER_BYTES))?;
        CarriedRotor::from_parts(angle, (spin, rest), inv_inertia)
    }
}

/// The inverse mass that the centre of a kinematic or static body has while it is written: that of 1 kg.
fn lent<S: Angular>() -> S::InvMass {
    S::InvMass::new(Ratio::from(1)).unwrap_or(S::INFINITE_MASS)
}

impl<C: Centre> Rigid<C> {
    /// Whether it is kinematic or static, its centre with a mass that can be written, and its rotor.
    pub(crate) fn parts(&self) -> (bool, C, &C::Rotor) {
        let (driven, centre) = match self.has_infinite_mass() {
            true => (true, self.centre.with_inv_mass(lent::<C::S>())),
            false => (false, self.centre),
        };
        (driven, centre, &self.rotor)
    }

    /// From the parts of one body. `None` where a kinematic or static body has a mass or an inertia.
    pub(crate) fn from_parts(driven: bool, centre: C, rotor: C::Rotor) -> Option<Self> {
        if !driven {
            return Some(Rigid { centre, rotor });
        }
        let unmoved = centre.inv_mass() == lent::<C::S>();
        let centre = centre.with_inv_mass(C::S::INFINITE_MASS);
        let unturned = rotor.inv_inertia() == C::S::ZERO.coef();
        (unmoved && unturned).then_some(Rigid { centre, rotor })
    }
}

impl<C: Centre<Rotor: SavedRotor> + Saved> Saved for Rigid<C> {
    const KIND: u16 = C::KIND + 2;
    const BYTES: usize = 1 + C::BYTES + <C::Rotor as SavedRotor>::BYTES;

    fn save(&self, write: &mut impl FnMut(u64, usize)) {
        let (driven, centre, rotor) = self.parts();
        write(driven.into(), 1);
        centre.save(write);
        rotor.save(write);
    }

    fn load(read: &mut impl FnMut(usize) -> u64) -> Option<Self> {
        let driven = match read(1) {
            mark @ 0..=1 => mark == 1,
            _ => return None,
        };
        Self::from_parts(driven, C::load(read)?, C::Rotor::load(read)?)
    }
}
