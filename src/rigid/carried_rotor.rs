//! The rotor of a body that carries: 24 bytes in a 32-bit scalar.

use super::angle::Angle;
use super::rotor::{Rotor, is_inverse};
use crate::scalar::CarryAngular;
use crate::time::Revolve;

/// A *carried* rotor keeps what rounding loses: an angle of twice the bits, and a remainder of the spin. With a method
/// that drifts by whole or half steps, rotation at a dyadic rate stays exact for ever. At any other rate it is exact to
/// the last digit of `h`.
///
/// ```
/// use fixstep::{DyadicStep, fixed::types::I16F16, prelude::*};
/// let centre = Carried::<I16F16>::new(vec2(0, 0)?, vec2(0, 0)?, 1)?;
/// let mut world = World::<_, 1>::new();
/// let top = world.add(Rigid::new(centre, 1)?.with_spin(dec!(0.25))?)?;
/// let step = DyadicStep::<I16F16, 1, 6>::new()?;
/// (0..256).for_each(|_| world.step(&mut Verlet, &mut (), &step));
/// assert_eq!(world.get(top)?.angle(), Angle::ZERO); // one turn in 4 s, exactly
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CarriedRotor<S: CarryAngular> {
    angle: S::Fine,
    spin: S,
    inv_inertia: S::Coef,
    remainder: S::Remainder,
}

impl<S: CarryAngular> CarriedRotor<S> {
    #[inline]
    fn kept(&self) -> (S, S::Remainder) {
        (self.spin, self.remainder)
    }

    #[inline]
    fn set_kept(&mut self, (spin, remainder): (S, S::Remainder)) {
        (self.spin, self.remainder) = (spin, remainder);
    }

    /// Angle and remainder of the spin, for a snapshot.
    pub(crate) const fn parts(&self) -> (S::Fine, S::Remainder) {
        (self.angle, self.remainder)
    }

    /// From a state that was one before, NaN and all; `None` where no body has the inverse inertia.
    pub(crate) fn from_parts(
        angle: S::Fine,
        (spin, remainder): (S, S::Remainder),
        inv_inertia: S::Coef,
    ) -> Option<Self> {
        is_inverse::<S>(inv_inertia).then_some(CarriedRotor {
            angle,
            spin,
            inv_inertia,
            remainder,
        })
    }
}

impl<S: CarryAngular> Revolve<S> for CarriedRotor<S> {
    #[inline(always)]
    fn revolved(self, h: S::Coef, halvings: u32) -> Self {
        let angle = S::fine_rotated(self.angle, self.kept(), h, halvings);
        CarriedRotor { angle, ..self }
    }

    #[inline(always)]
    fn revolved_dyadic(self, num: u32, shift: u32) -> Self {
        let angle = S::fine_rotated_dyadic(self.angle, self.kept(), num, shift);
        CarriedRotor { angle, ..self }
    }
}

impl<S: CarryAngular> Rotor<S> for CarriedRotor<S> {
    #[inline]
    fn new(inv_inertia: S::Coef) -> Self {
        CarriedRotor {
            angle: S::fine(Angle::<S>::ZERO.count()),
            spin: S::ZERO,
            inv_inertia,
            remainder: S::NO_REMAINDER,
        }
    }

    #[inline]
    fn angle(&self) -> Angle<S> {
        Angle::from_count(S::coarse(self.angle))
    }

    #[inline]
    fn spin(&self) -> S {
        self.spin
    }

    #[inline]
    fn inv_inertia(&self) -> S::Coef {
        self.inv_inertia
    }

    #[inline]
    fn set_angle(&mut self, angle: Angle<S>) {
        self.angle = S::fine(angle.count());
    }

    #[inline]
    fn set_spin(&mut self, spin: S) {
        self.set_kept((spin, S::NO_REMAINDER));
    }

    #[inline]
    fn rotate_by(&mut self, spin: S, factor: S::Coef) {
        self.angle = S::fine_rotated(self.angle, (spin, S::NO_REMAINDER), factor, 0);
    }

    #[inline]
    fn twist(&mut self, change: S) {
        self.spin = self.spin.plus(change);
    }

    #[inline]
    fn twist_by(&mut self, value: S, factor: S::Coef) {
        self.set_kept(S::kicked(self.kept(), value, factor));
    }

    #[inline]
    fn twist_by_sum(&mut self, sum: S::Sum, factor: S::Coef) {
        self.set_kept(S::twisted(self.kept(), sum, factor));
    }

    #[inline]
    fn damp(&mut self, loss: S::Coef) {
        self.set_kept(S::damped(self.kept(), loss));
    }

    #[inline]
    fn reverse(&mut self) {
        self.set_kept(S::reversed(self.kept()));
    }

    fn spin_to_f64(&self) -> f64 {
        S::kept_to_f64(self.kept())
    }

    fn write_left_over(&self, write: &mut impl FnMut(u64)) {
        S::fine_halves(self.angle).into_iter().for_each(&mut *write);
        write(S::remainder_left_over(self.remainder));
    }
}
