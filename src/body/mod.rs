//! What the stages ask of a body.

mod carried;
pub(crate) mod id;
mod point;
mod range_checked;
mod spin;

use crate::error::Error;
use crate::scalar::Scalar;
use crate::time::TimeStep;
use crate::vec2::Vec2;

pub use carried::Carried;
pub use id::{BodyId, Stale};
pub use point::Point;
pub use range_checked::RangeChecked;
pub use spin::{NoSpin, Spin};

/// What the stages ask of a body. A body that keeps the remainders of its roundings implements
/// the same verbs and takes part in every scene.
pub trait Body: Copy + 'static {
    /// Its number type.
    type S: Scalar;

    /// How it turns: [`NoSpin`](crate::body::NoSpin) for a point, which has no size and costs nothing.
    type Spin: Spin<Self::S>;

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

    /// `v = 0`, and no spin, with all that was left over: of any body, driven or not.
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

    /// `x += h v`, and it turns by `h` times its spin.
    fn drift(&mut self, step: &impl TimeStep<Self::S>);

    /// `x += h/2 v`, in the same way.
    fn drift_half(&mut self, step: &impl TimeStep<Self::S>);

    /// `x += factor v`, for a part of a step, without a [`drift_angle_by`](Body::drift_angle_by); a body that keeps
    /// remainders moves by all of v.
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

    /// Its spin, turns/s.
    #[inline]
    #[must_use]
    fn spin(&self) -> Self::Spin {
        Self::Spin::NONE
    }

    /// Its spin changes by `change`.
    #[inline]
    fn twist(&mut self, change: Self::Spin) {
        let _ = change;
    }

    /// Its spin changes by `factor * spin`, for a product that is not rounded yet: what [`kick_by`](Body::kick_by) is to
    /// velocities.
    #[inline]
    fn twist_part(&mut self, spin: Self::Spin, factor: <Self::S as Scalar>::Coef) {
        self.twist(spin.part(factor));
    }

    /// It turns by `h` times its spin: the other half of [`drift`](Body::drift), which does it too. For
    /// those who move a body in another way.
    #[inline]
    fn drift_angle(&mut self, step: &impl TimeStep<Self::S>) {
        let _ = step;
    }

    /// It turns by `h/2` times its spin.
    #[inline]
    fn drift_angle_half(&mut self, step: &impl TimeStep<Self::S>) {
        let _ = step;
    }

    /// It turns by `factor` times its spin.
    #[inline]
    fn drift_angle_by(&mut self, factor: <Self::S as Scalar>::Coef) {
        let _ = factor;
    }

    /// It turns by `factor` times `spin`, which is not its own: what [`move_by`](Body::move_by) is to places.
    #[inline]
    fn rotate_by(&mut self, spin: Self::Spin, factor: <Self::S as Scalar>::Coef) {
        let _ = (spin, factor);
    }

    /// Whether no force moves it: what it does is given.
    #[inline]
    #[must_use]
    fn has_infinite_mass(&self) -> bool {
        false
    }

    /// Kinetic energy of its rotation, J; for reports.
    #[must_use]
    fn spin_energy(&self) -> f64 {
        0.0
    }

    /// Angular momentum about its own centre, kg m²/s; for reports.
    #[must_use]
    fn spin_momentum(&self) -> f64 {
        0.0
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
    note = "a point in fixed point can: `RangeChecked<Point<I16F16>>`"
)]
pub trait Reverse: Body {
    /// `v = -v`, and its spin as well.
    fn reverse(&mut self);
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
