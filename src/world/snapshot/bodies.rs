//! The saved state of points. `rigid/saved.rs` has that of rigid bodies.
//!
//! ```text
//! Point     x y            u v         1/m
//! Carried   x x y y        u v         1/m    r r      two halves of each position, remainders of u and v
//! ```

use super::Saved;
use crate::body::{Body, Carried, Point};
use crate::scalar::{Carry, Scalar, Stored};
use crate::vec2::Vec2;

impl<S: Scalar<InvMass: Stored> + Stored> Saved for Point<S> {
    const KIND: u16 = 1;
    const BYTES: usize = 4 * S::BYTES + <S::InvMass as Stored>::BYTES;

    fn save(&self, write: &mut impl FnMut(u64, usize)) {
        let (position, velocity) = (self.position().array(), self.velocity().array());
        for scalar in position.into_iter().chain(velocity) {
            write(scalar.store(), S::BYTES);
        }
        write(self.inv_mass().store(), <S::InvMass as Stored>::BYTES);
    }

    fn load(read: &mut impl FnMut(usize) -> u64) -> Option<Self> {
        let mut scalar = || S::restore(read(S::BYTES));
        let position = Vec2::new(scalar()?, scalar()?);
        let velocity = Vec2::new(scalar()?, scalar()?);
        let inv_mass = S::InvMass::restore(read(<S::InvMass as Stored>::BYTES))?;
        Point::from_parts(position, velocity, inv_mass)
    }
}

impl<S: Carry + Scalar<InvMass: Stored> + Stored> Saved for Carried<S> {
    const KIND: u16 = 2;
    const BYTES: usize = 6 * S::BYTES + <S::InvMass as Stored>::BYTES + 2 * S::REMAINDER_BYTES;

    fn save(&self, write: &mut impl FnMut(u64, usize)) {
        for half in self.fine_position().into_iter().flat_map(S::halves) {
            write(half, S::BYTES);
        }
        for scalar in self.velocity().array() {
            write(scalar.store(), S::BYTES);
        }
        write(self.inv_mass().store(), <S::InvMass as Stored>::BYTES);
        for remainder in self.remainder() {
            write(S::remainder_bits(remainder), S::REMAINDER_BYTES);
        }
    }

    fn load(read: &mut impl FnMut(usize) -> u64) -> Option<Self> {
        let mut fine = || S::from_halves([read(S::BYTES), read(S::BYTES)]);
        let fine = [fine()?, fine()?];
        let mut scalar = || S::restore(read(S::BYTES));
        let velocity = Vec2::new(scalar()?, scalar()?);
        let inv_mass = S::InvMass::restore(read(<S::InvMass as Stored>::BYTES))?;
        let mut remainder = || S::from_remainder_bits(read(S::REMAINDER_BYTES));
        Carried::from_parts(fine, velocity, inv_mass, [remainder()?, remainder()?])
    }
}
