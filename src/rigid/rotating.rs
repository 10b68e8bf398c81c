//! What a force that rotates bodies needs from them.

use super::angle::{Angle, Rotation};
use super::rotor::Rotor;
use super::{Centre, Rigid};
use crate::body::{Body, RangeChecked};
use crate::scalar::{Angular, Scalar};
use crate::vec2::Vec2;

type Coef<B> = <<B as Body>::S as Scalar>::Coef;

/// A body that rotates.
///
/// An *arm* is the vector from the centre of mass to a point of the body, in the axes of the world.
///
/// ```
/// use fixstep::prelude::*;
/// let centre = Point::<f32>::new(vec2(0, 0)?, vec2(0, 0)?, 1)?;
/// let wheel = Rigid::new(centre, 1)?.with_spin(1)?; // one turn a second
/// let rim = wheel.velocity_at(vec2(2, 0)?);
/// assert!((rim.y - 2.0 * core::f32::consts::TAU).abs() < 1e-5); // ω r
/// # Ok::<(), fixstep::Error>(())
/// ```
pub trait Rotating: Body<S: Angular> {
    /// Its angle.
    #[must_use]
    fn angle(&self) -> Angle<Self::S>;

    /// Its spin, turns/s.
    #[must_use]
    fn turns_per_second(&self) -> Self::S;

    /// `1 / 2πI`: the spin that one unit of angular momentum gives. It is zero if no torque can change the spin.
    #[must_use]
    fn inv_inertia(&self) -> Coef<Self>;

    /// Its spin changes by `factor * value`, for a product that is not rounded yet.
    fn twist_by(&mut self, value: Self::S, factor: Coef<Self>);

    /// Its spin changes by `change`, turns/s.
    fn spin_up(&mut self, change: Self::S);

    /// It loses `loss` of its spin, as [`Body::damp`] takes velocity.
    fn damp_spin(&mut self, loss: Coef<Self>);

    /// An impulse (kg m/s) at the end of an arm (m): `v += J / m` and `s += r×J / 2πI`, each rounded once.
    fn push_off(&mut self, arm: Vec2<Self::S>, impulse: Vec2<Self::S>);

    /// An impulse (kg m/s) at a point of the world (m).
    ///
    /// ```
    /// use fixstep::{dec, vec2, Point, Rigid, Rotating};
    /// // A box of 2 kg, 1 m by 1 m: I = m (w² + h²) / 12.
    /// let centre = Point::<f32>::new(vec2(3, 3)?, vec2(0, 0)?, 2)?;
    /// let mut body = Rigid::new(centre, dec!(0.33333333333))?;
    /// body.push_at(vec2(dec!(3.5), 3)?, vec2(0, 4)?); // upwards, on its right side
    /// assert_eq!(body.velocity(), vec2(0, 2)?);
    /// assert!((body.spin() - 6.0 / core::f32::consts::TAU).abs() < 1e-6); // 0.5 m · 4 kg m/s / I
    /// # Ok::<(), fixstep::Error>(())
    /// ```
    #[inline]
    fn push_at(&mut self, point: Vec2<Self::S>, impulse: Vec2<Self::S>) {
        self.push_off(point - self.position(), impulse);
    }

    /// An angular impulse, kg m²/s: `s += L / 2πI`.
    #[inline]
    fn push_angular(&mut self, angular_impulse: Self::S) {
        self.twist_by(angular_impulse, self.inv_inertia());
    }

    /// Where a point of the body, in its own axes, is in the world.
    #[inline]
    #[must_use]
    fn to_world(&self, own: Vec2<Self::S>) -> Vec2<Self::S> {
        self.position() + self.rotation().rotate(own)
    }

    /// Where a point of the world is in the axes of the body.
    #[inline]
    #[must_use]
    fn to_own(&self, world: Vec2<Self::S>) -> Vec2<Self::S> {
        self.rotation().rotate_back(world - self.position())
    }

    /// The rotation from the axes of the body to those of the world.
    #[inline]
    #[must_use]
    fn rotation(&self) -> Rotation<Self::S> {
        self.angle().rotation()
    }

    /// Velocity of the end of an arm, m/s: `v + ω × r`.
    #[inline]
    #[must_use]
    fn velocity_off(&self, arm: Vec2<Self::S>) -> Vec2<Self::S> {
        let omega = Self::S::product(self.turns_per_second().coef(), Self::S::TAU);
        self.velocity() + arm.perp().scaled(omega)
    }

    /// Velocity of the body at a point of the world, m/s.
    #[inline]
    #[must_use]
    fn velocity_at(&self, point: Vec2<Self::S>) -> Vec2<Self::S> {
        self.velocity_off(point - self.position())
    }
}

impl<C: Centre> Rigid<C> {
    /// Whether a torque changes its spin. Infinity times an inverse inertia of zero would be NaN.
    #[inline]
    fn can_turn(&self) -> bool {
        self.rotor.inv_inertia() != C::S::ZERO.coef()
    }
}

impl<C: Centre> Rotating for Rigid<C> {
    #[inline]
    fn angle(&self) -> Angle<C::S> {
        self.rotor.angle()
    }

    #[inline]
    fn turns_per_second(&self) -> C::S {
        self.rotor.spin()
    }

    #[inline]
    fn inv_inertia(&self) -> Coef<C> {
        self.rotor.inv_inertia()
    }

    #[inline]
    fn twist_by(&mut self, value: C::S, factor: Coef<C>) {
        if self.can_turn() {
            self.rotor.twist_by(value, factor);
        }
    }

    #[inline]
    fn spin_up(&mut self, change: C::S) {
        if self.can_turn() {
            self.rotor.twist(change);
        }
    }

    #[inline]
    fn damp_spin(&mut self, loss: Coef<C>) {
        if self.can_turn() {
            self.rotor.damp(loss);
        }
    }

    #[inline]
    fn push_off(&mut self, arm: Vec2<C::S>, impulse: Vec2<C::S>) {
        self.push(impulse);
        if self.can_turn() {
            let moment = arm.cross(impulse);
            self.rotor.twist_by_sum(moment, self.rotor.inv_inertia());
        }
    }
}

impl<B: Rotating> Rotating for RangeChecked<B> {
    #[inline]
    fn angle(&self) -> Angle<B::S> {
        self.body().angle()
    }

    #[inline]
    fn turns_per_second(&self) -> B::S {
        self.body().turns_per_second()
    }

    #[inline]
    fn inv_inertia(&self) -> Coef<B> {
        self.body().inv_inertia()
    }

    #[inline]
    fn twist_by(&mut self, value: B::S, factor: Coef<B>) {
        self.change(|body| body.twist_by(value, factor));
    }

    #[inline]
    fn spin_up(&mut self, change: B::S) {
        self.change(|body| body.spin_up(change));
    }

    #[inline]
    fn damp_spin(&mut self, loss: Coef<B>) {
        self.change(|body| body.damp_spin(loss));
    }

    #[inline]
    fn push_off(&mut self, arm: Vec2<B::S>, impulse: Vec2<B::S>) {
        self.change(|body| body.push_off(arm, impulse));
    }
}
