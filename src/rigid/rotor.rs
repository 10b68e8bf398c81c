//! How a body rotates: its angle, its spin and its resistance to a torque.
//!
//! ```text
//! θ' = θ + h s            s in turns/s; ω = 2π s
//! s' = s + L / (2π I)     L an angular impulse, kg m²/s
//! ```
//!
//! Source: Hecker, "Physics, Part 2: Angular Effects" (Game Developer, 1996), for the torque by the
//! perpendicular dot product and the moment of inertia; the factor 2π is that of the unit.

use core::fmt::Debug;

use super::angle::Angle;
use crate::ratio::Ratio;
use crate::scalar::{Angular, Factor, Scalar};
use crate::time::Revolve;

/// The part of a rigid body that rotates: angle, spin and inverse inertia.
///
/// ```
/// use fixstep::{rigid::{PlainRotor, Rotor}, scalar::Scalar};
/// let mut rotor = PlainRotor::<f32>::new(0.5);
/// rotor.twist(3.0);
/// rotor.twist_by(4.0, rotor.inv_inertia());
/// assert_eq!(rotor.spin(), 5.0);
/// ```
pub trait Rotor<S: Angular>: Revolve<S> + Copy + Debug + PartialEq + 'static {
    /// At rest at angle zero, with `1 / 2πI`.
    #[must_use]
    fn new(inv_inertia: S::Coef) -> Self;

    /// Its angle, rounded.
    #[must_use]
    fn angle(&self) -> Angle<S>;

    /// Its spin, turns/s, rounded.
    #[must_use]
    fn spin(&self) -> S;

    /// `1 / 2πI`: the spin that one unit of angular momentum gives. It is zero if no torque can change the spin.
    #[must_use]
    fn inv_inertia(&self) -> S::Coef;

    /// Sets the angle, without a remainder.
    fn set_angle(&mut self, angle: Angle<S>);

    /// Sets the spin, without a remainder.
    fn set_spin(&mut self, spin: S);

    /// `θ += factor * spin`, of a spin that is not its own.
    fn rotate_by(&mut self, spin: S, factor: S::Coef);

    /// `s += change`.
    fn twist(&mut self, change: S);

    /// `s += factor * value`.
    fn twist_by(&mut self, value: S, factor: S::Coef);

    /// `s += factor * sum`.
    fn twist_by_sum(&mut self, sum: S::Sum, factor: S::Coef);

    /// `s -= loss * s`, as [`Body::damp`](crate::Body::damp) does.
    fn damp(&mut self, loss: S::Coef);

    /// `s = -s`.
    fn reverse(&mut self);

    /// Its spin with its remainder, turns/s; for reports.
    #[must_use]
    fn spin_to_f64(&self) -> f64 {
        self.spin().to_f64()
    }

    /// What its state holds beyond angle and spin, for a hash.
    fn write_left_over(&self, write: &mut impl FnMut(u64)) {
        let _ = write;
    }
}

/// The compact rotor: 16 bytes in 32-bit fixed point, 12 in `f32`.
///
/// ```
/// use fixstep::{Angle, rigid::{PlainRotor, Rotor}};
/// let rotor = PlainRotor::<f32>::new(1.0);
/// assert_eq!((rotor.angle(), rotor.spin()), (Angle::ZERO, 0.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlainRotor<S: Angular> {
    angle: S::Turns,
    spin: S,
    inv_inertia: S::Coef,
}

impl<S: Angular> PlainRotor<S> {
    /// From a state that was one before, NaN and all; `None` where no body has the inverse inertia.
    pub(crate) fn from_parts(angle: Angle<S>, spin: S, inv_inertia: S::Coef) -> Option<Self> {
        is_inverse::<S>(inv_inertia).then_some(PlainRotor {
            angle: angle.count(),
            spin,
            inv_inertia,
        })
    }
}

/// Whether a body can have it as `1 / 2πI`: zero, or finite and greater.
pub(super) fn is_inverse<S: Scalar>(inv_inertia: S::Coef) -> bool {
    // The least coefficient rounds to nothing even of the largest scalar: a million of it do not.
    let greater = |million| S::product(inv_inertia, million).scale(S::MAX) > S::ZERO;
    let finite = inv_inertia.scale(S::ZERO) == S::ZERO;
    inv_inertia == S::ZERO.coef()
        || finite && S::Coef::new(Ratio::from(1_000_000)).is_some_and(greater)
}

impl<S: Angular> Revolve<S> for PlainRotor<S> {
    #[inline(always)]
    fn revolved(self, h: S::Coef, halvings: u32) -> Self {
        let angle = S::advanced(self.angle, self.spin, h, halvings);
        PlainRotor { angle, ..self }
    }

    #[inline(always)]
    fn revolved_dyadic(self, num: u32, shift: u32) -> Self {
        let angle = S::advanced_dyadic(self.angle, self.spin, num, shift);
        PlainRotor { angle, ..self }
    }
}

impl<S: Angular> Rotor<S> for PlainRotor<S> {
    #[inline]
    fn new(inv_inertia: S::Coef) -> Self {
        PlainRotor {
            angle: Angle::<S>::ZERO.count(),
            spin: S::ZERO,
            inv_inertia,
        }
    }

    #[inline]
    fn angle(&self) -> Angle<S> {
        Angle::from_count(self.angle)
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
        self.angle = angle.count();
    }

    #[inline]
    fn set_spin(&mut self, spin: S) {
        self.spin = spin;
    }

    #[inline]
    fn rotate_by(&mut self, spin: S, factor: S::Coef) {
        self.angle = S::advanced(self.angle, spin, factor, 0);
    }

    #[inline]
    fn twist(&mut self, change: S) {
        self.spin = self.spin.plus(change);
    }

    #[inline]
    fn twist_by(&mut self, value: S, factor: S::Coef) {
        self.twist(factor.scale(value));
    }

    #[inline]
    fn twist_by_sum(&mut self, sum: S::Sum, factor: S::Coef) {
        self.twist(S::weighed(sum, factor));
    }

    #[inline]
    fn damp(&mut self, loss: S::Coef) {
        self.spin = self.spin.minus(self.spin.lost(loss));
    }

    #[inline]
    fn reverse(&mut self) {
        self.spin = self.spin.negated();
    }
}
