//! Any function of time and of a body's own state.

use crate::body::Body;
use crate::force::Force;
use crate::scalar::Scalar;
use crate::time::{Now, Time, TimeStep};
use crate::vec2::Vec2;

/// A force, in newtons, that `F` computes from the time and the body alone; an [`Effort`], for bodies that turn a
/// force and a torque.
///
/// ```
/// use fixstep::{vec2, Body, PerBody, Point, Time, Vec2};
/// // Wind that blows above the ground only.
/// let wind = PerBody(|_: Time, body: &Point<f32>| {
///     let blows = body.position().y > 0.0;
///     Vec2::new(if blows { 2.0 } else { 0.0 }, 0.0)
/// });
/// ```
#[derive(Clone, Copy, Debug)]
pub struct PerBody<F>(
    /// The function.
    pub F,
);

/// What a function says that a body feels: a force, or for a body that turns a
/// [`Wrench`](crate::rigid::torque::Wrench).
///
/// ```
/// use fixstep::{PerBody, Time, prelude::*, rigid::torque::Wrench};
/// // A force is an effort, and so is a force with a torque.
/// let push = PerBody(|_: Time, _: &Point<f32>| Vec2::new(1.0, 0.0));
/// let both = PerBody(|_: Time, _: &Rigid<Point<f32>>| Wrench { force: Vec2::ZERO, torque: 2.0 });
/// ```
pub trait Effort<B: Body> {
    /// Changes the velocity of `live`, as `seen` feels it for a time `h`.
    fn act(self, h: <B::S as Scalar>::Coef, seen: &B, live: &mut B);
}

/// A force, N.
impl<B: Body> Effort<B> for Vec2<B::S> {
    #[inline]
    fn act(self, h: <B::S as Scalar>::Coef, seen: &B, live: &mut B) {
        live.kick_by(self, B::S::product(h, seen.inv_mass().into()));
    }
}

impl<B: Body, E: Effort<B>, F: FnMut(Time, &B) -> E> Force<B> for PerBody<F> {
    const COUPLES: bool = false;

    #[inline]
    fn field<H: TimeStep<B::S>>(&mut self, now: &Now<H>, seen: &B, live: &mut B) {
        let effort = (self.0)(now.time(), seen);
        effort.act(now.step.coef(), seen, live);
    }
}
