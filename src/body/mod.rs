//! Bodies: a point, a carried point, a range-checked body, and the trait for your own.

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

/// What the stages of a method need from a body. A *carried* body keeps what rounding loses; it
/// implements the same methods and works in every scene.
///
/// ```
/// use fixstep::{Body, Point, vec2};
/// let mut ball = Point::<f32>::new(vec2(0, 0)?, vec2(1, 0)?, 2)?;
/// ball.kick(vec2(3, 0)?);
/// assert_eq!(ball.velocity(), vec2(4, 0)?);
/// # Ok::<(), fixstep::Error>(())
/// ```
pub trait Body: Copy + 'static {
    /// Its number type.
    type S: Scalar;

    /// Its type of spin. A point has [`NoSpin`], which takes no memory and costs nothing.
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

    /// `v += dv`, m/s: the same change of velocity for every mass.
    fn kick(&mut self, dv: Vec2<Self::S>);

    /// `v.y += dv`, m/s: a [`kick`](Body::kick) along y only.
    #[inline]
    fn kick_y(&mut self, dv: Self::S) {
        self.kick(Vec2::new(Self::S::ZERO, dv));
    }

    /// `v += factor * value`. A carried body keeps the remainder of this product.
    #[inline]
    fn kick_by(&mut self, value: Vec2<Self::S>, factor: <Self::S as Scalar>::Coef) {
        self.kick(value.scaled(factor));
    }

    /// `v -= factor * value`, like [`kick_by`](Body::kick_by).
    #[inline]
    fn brake_by(&mut self, value: Vec2<Self::S>, factor: <Self::S as Scalar>::Coef) {
        self.kick(-value.scaled(factor));
    }

    /// Applies an impulse, kg m/s: `v += impulse / m`.
    ///
    /// ```
    /// # use fixstep::{Body, Point, vec2};
    /// let mut ball = Point::<f32>::new(vec2(0, 0)?, vec2(1, 0)?, 2)?; // 2 kg
    /// ball.push(vec2(0, 4)?);
    /// assert_eq!(ball.velocity(), vec2(1, 2)?);
    /// # Ok::<(), fixstep::Error>(())
    /// ```
    fn push(&mut self, impulse: Vec2<Self::S>);

    /// `v -= loss * v` for a loss from 0 to 1. The velocity never changes sign. In fixed point each
    /// component that is not zero loses at least one unit, so the body comes to rest.
    #[inline]
    fn damp(&mut self, loss: <Self::S as Scalar>::Coef) {
        self.kick(-self.velocity().map(|v| v.lost(loss)));
    }

    /// `v = 0`, spin zero and remainders zero, for any body, also a kinematic one.
    #[inline]
    fn halt(&mut self) {
        self.kick(-self.velocity());
    }

    /// `v += factor * (x - from)`. A carried body includes its remainders.
    #[inline]
    fn kick_from(&mut self, from: Vec2<Self::S>, factor: <Self::S as Scalar>::Coef) {
        self.kick_by(self.position() - from, factor);
    }

    /// `x += dx`, m.
    fn shift(&mut self, dx: Vec2<Self::S>);

    /// `x += factor * value`. A carried body keeps the remainder of this product.
    #[inline]
    fn move_by(&mut self, value: Vec2<Self::S>, factor: <Self::S as Scalar>::Coef) {
        self.shift(value.scaled(factor));
    }

    /// `x += h v`, and rotates the body by `h` times its spin.
    fn drift(&mut self, step: &impl TimeStep<Self::S>);

    /// The same for half a step: `x += h/2 v`.
    fn drift_half(&mut self, step: &impl TimeStep<Self::S>);

    /// `x += factor v`, with the remainder of v if carried. [`drift_angle_by`](Body::drift_angle_by) rotates.
    #[inline]
    fn drift_by(&mut self, factor: <Self::S as Scalar>::Coef) {
        self.move_by(self.velocity(), factor);
    }

    /// `x += a z + b v`, `v += c z + d v`, both from the old state. `z = x - from`, `by = [a, b, c, d]`.
    #[inline]
    fn swing(&mut self, from: Vec2<Self::S>, by: [<Self::S as Scalar>::Coef; 4]) {
        let ([a, b, c, d], z, v) = (by, self.position() - from, self.velocity());
        self.move_by(z, a);
        self.move_by(v, b);
        self.kick_by(z, c);
        self.kick_by(v, d);
    }

    /// Mirrors the state in the point `about`: `x = 2 about - x` and `v = -v`.
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

    /// Adds `change` to the spin.
    #[inline]
    fn twist(&mut self, change: Self::Spin) {
        let _ = change;
    }

    /// Adds `factor * spin` to the spin, as [`kick_by`](Body::kick_by) does for velocities.
    #[inline]
    fn twist_part(&mut self, spin: Self::Spin, factor: <Self::S as Scalar>::Coef) {
        self.twist(spin.part(factor));
    }

    /// Rotates by `h` times its spin, as part of [`drift`](Body::drift) or after another way to move.
    #[inline]
    fn drift_angle(&mut self, step: &impl TimeStep<Self::S>) {
        let _ = step;
    }

    /// Rotates by `h/2` times its spin.
    #[inline]
    fn drift_angle_half(&mut self, step: &impl TimeStep<Self::S>) {
        let _ = step;
    }

    /// Rotates by `factor` times its spin.
    #[inline]
    fn drift_angle_by(&mut self, factor: <Self::S as Scalar>::Coef) {
        let _ = factor;
    }

    /// Rotates by `factor * spin`, where `spin` is not its own, as [`move_by`](Body::move_by) does for positions.
    #[inline]
    fn rotate_by(&mut self, spin: Self::Spin, factor: <Self::S as Scalar>::Coef) {
        let _ = (spin, factor);
    }

    /// Whether the body is kinematic or static: no force moves it.
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

    /// Angular momentum about its centre, kg m²/s; for reports.
    #[must_use]
    fn spin_momentum(&self) -> f64 {
        0.0
    }

    /// Passes the exact bits of its state to `write`, for a hash. Override it if your body has more state.
    fn write_state(&self, write: &mut impl FnMut(u64)) {
        let (position, velocity) = (self.position().array(), self.velocity().array());
        position
            .into_iter()
            .chain(velocity)
            .for_each(|scalar| write(scalar.bits()));
    }

    /// Whether all its state is finite and not at an end of the range.
    #[must_use]
    fn is_inside(&self) -> bool {
        self.position().is_inside() && self.velocity().is_inside()
    }
}

/// A body whose steps can be undone: its methods add without loss, and its velocity can be reversed.
///
/// Your own body must obey two laws, unless a sum saturates. A method with the negated argument undoes
/// the method. After `reverse`, a second [`drift`](Body::drift) undoes the first.
///
/// ```
/// use fixstep::{Body, Point, Reverse, Step, vec2, fixed::types::I16F16};
/// let mut ball = Point::<I16F16>::new(vec2(1, 2)?, vec2(3, -4)?, 1)?;
/// ball.drift(&Step::hz(60)?);
/// ball.reverse();
/// ball.drift(&Step::hz(60)?);
/// assert_eq!(ball.position(), vec2(1, 2)?);
/// # Ok::<(), fixstep::Error>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot go back: its sums lose bits",
    note = "a point in fixed point can: `RangeChecked<Point<I16F16>>`"
)]
pub trait Reverse: Body {
    /// `v = -v`, and the same for the spin.
    fn reverse(&mut self);
}

/// A finite number minus itself is zero; infinity and NaN give NaN.
#[inline]
pub(crate) fn finite<S: Scalar>(field: &'static str, v: Vec2<S>) -> Result<(), Error> {
    if v.map(|s| s.minus(s)) == Vec2::ZERO {
        Ok(())
    } else {
        Err(Error::NotFinite { field })
    }
}
