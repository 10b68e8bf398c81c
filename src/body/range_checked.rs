//! A body that remembers whether it was at an end of the range.
//!
//! A plain [`Point`](crate::Point) does not record saturation. If it saturates in the middle of a step and
//! returns inside before the end, nothing shows it. Here every method tests what it has changed. It costs
//! two comparisons per axis and, in 32 bits, 4 bytes per body.

use crate::body::{Body, Reverse};
use crate::scalar::Scalar;
use crate::time::TimeStep;
use crate::vec2::Vec2;

/// A body with a permanent mark: whether it was ever at an end of the range, or not finite.
///
/// Every method tests the position, velocity or spin that it changes. A sum that saturates sets the mark.
/// The motion and the state hash are those of the body, to the bit. The mark is not part of the state;
/// it tells whether the history can be trusted.
///
/// ```
/// use fixstep::{vec2, Body, Point, RangeChecked, fixed::types::I16F16};
/// let mut ball = RangeChecked::new(Point::<I16F16>::new(vec2(0, 0)?, vec2(0, 0)?, 1)?);
/// ball.kick(vec2(30_000, 0)?);
/// assert!(!ball.was_outside());
/// ball.kick(vec2(30_000, 0)?); // saturates
/// ball.kick(vec2(-30_000, 0)?);
/// assert!(ball.is_inside() && ball.was_outside());
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RangeChecked<B> {
    body: B,
    outside: bool,
}

impl<B: Body> RangeChecked<B> {
    /// Checks `body` from now on. A body at an end of the range is marked at once.
    #[inline]
    #[must_use]
    pub fn new(body: B) -> RangeChecked<B> {
        RangeChecked::marked(body, false)
    }

    /// With a saved mark; a body at an end of the range is marked in any case.
    pub(crate) fn marked(body: B, outside: bool) -> RangeChecked<B> {
        let outside = outside || !body.is_inside();
        RangeChecked { body, outside }
    }

    /// The body itself.
    #[inline]
    #[must_use]
    pub const fn body(&self) -> &B {
        &self.body
    }

    /// Whether it was at an end of the range at any time since the check began.
    #[inline]
    #[must_use]
    pub const fn was_outside(&self) -> bool {
        self.outside
    }

    /// Clears the mark if the body is inside now. Do not undo steps made before this call: they
    /// could lead to a different state.
    #[inline]
    pub fn forget(&mut self) {
        self.outside = !self.body.is_inside();
    }

    /// Applies `change` to the body between steps, and tests the result.
    ///
    /// ```
    /// # use fixstep::{vec2, Body, Point, RangeChecked, fixed::types::I16F16};
    /// # let mut ball = RangeChecked::new(Point::<I16F16>::new(vec2(0, 0)?, vec2(0, 0)?, 1)?);
    /// let there = vec2(3, 4)?;
    /// ball.change(|point| point.teleport(there))?;
    /// assert_eq!(ball.position(), there);
    /// # Ok::<(), fixstep::Error>(())
    /// ```
    pub fn change<R>(&mut self, change: impl FnOnce(&mut B) -> R) -> R {
        let result = change(&mut self.body);
        self.outside |= !self.body.is_inside();
        result
    }

    #[inline]
    fn look(&mut self, at: Vec2<B::S>) {
        self.outside |= !at.is_inside();
    }
}

/// Each method calls that of the body and tests the half of the state that it changes.
macro_rules! verbs {
    ($($verb:ident($($name:ident: $type:ty),*) changes $half:ident;)*) => {
        $(
            #[inline]
            fn $verb(&mut self, $($name: $type),*) {
                self.body.$verb($($name),*);
                self.look(self.body.$half());
            }
        )*
    };
}

impl<B: Body> Body for RangeChecked<B> {
    type S = B::S;
    type Spin = B::Spin;

    #[inline]
    fn position(&self) -> Vec2<B::S> {
        self.body.position()
    }

    #[inline]
    fn velocity(&self) -> Vec2<B::S> {
        self.body.velocity()
    }

    #[inline]
    fn inv_mass(&self) -> <B::S as Scalar>::InvMass {
        self.body.inv_mass()
    }

    verbs! {
        kick(dv: Vec2<B::S>) changes velocity;
        kick_y(dv: B::S) changes velocity;
        kick_by(value: Vec2<B::S>, factor: <B::S as Scalar>::Coef) changes velocity;
        brake_by(value: Vec2<B::S>, factor: <B::S as Scalar>::Coef) changes velocity;
        push(impulse: Vec2<B::S>) changes velocity;
        damp(loss: <B::S as Scalar>::Coef) changes velocity;
        kick_from(from: Vec2<B::S>, factor: <B::S as Scalar>::Coef) changes velocity;
        shift(dx: Vec2<B::S>) changes position;
        move_by(value: Vec2<B::S>, factor: <B::S as Scalar>::Coef) changes position;
        drift_by(factor: <B::S as Scalar>::Coef) changes position;
        drift(step: &impl TimeStep<B::S>) changes position;
        drift_half(step: &impl TimeStep<B::S>) changes position;
    }

    #[inline]
    fn swing(&mut self, from: Vec2<B::S>, by: [<B::S as Scalar>::Coef; 4]) {
        self.change(|body| body.swing(from, by));
    }

    #[inline]
    fn mirror(&mut self, about: Vec2<B::S>) {
        self.change(|body| body.mirror(about));
    }

    #[inline]
    fn halt(&mut self) {
        self.body.halt();
    }

    #[inline]
    fn spin(&self) -> B::Spin {
        self.body.spin()
    }

    #[inline]
    fn twist(&mut self, change: B::Spin) {
        self.change(|body| body.twist(change));
    }

    #[inline]
    fn twist_part(&mut self, spin: B::Spin, factor: <B::S as Scalar>::Coef) {
        self.change(|body| body.twist_part(spin, factor));
    }

    #[inline]
    fn drift_angle(&mut self, step: &impl TimeStep<B::S>) {
        self.body.drift_angle(step);
    }

    #[inline]
    fn drift_angle_half(&mut self, step: &impl TimeStep<B::S>) {
        self.body.drift_angle_half(step);
    }

    #[inline]
    fn drift_angle_by(&mut self, factor: <B::S as Scalar>::Coef) {
        self.body.drift_angle_by(factor);
    }

    #[inline]
    fn rotate_by(&mut self, spin: B::Spin, factor: <B::S as Scalar>::Coef) {
        self.body.rotate_by(spin, factor);
    }

    #[inline]
    fn has_infinite_mass(&self) -> bool {
        self.body.has_infinite_mass()
    }

    fn spin_energy(&self) -> f64 {
        self.body.spin_energy()
    }

    fn spin_momentum(&self) -> f64 {
        self.body.spin_momentum()
    }

    fn write_state(&self, write: &mut impl FnMut(u64)) {
        self.body.write_state(write);
    }

    #[inline]
    fn is_inside(&self) -> bool {
        self.body.is_inside()
    }
}

impl<B: Reverse> Reverse for RangeChecked<B> {
    #[inline]
    fn reverse(&mut self) {
        self.body.reverse();
    }
}
