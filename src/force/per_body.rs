//! Any function of time and of a body's own state.

use crate::body::Body;
use crate::force::Force;
use crate::scalar::Scalar;
use crate::step::TimeStep;
use crate::time::{Now, Time};
use crate::vec2::Vec2;

/// A force, in newtons, that `F` computes from the time and the body alone.
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

impl<B: Body, F: FnMut(Time, &B) -> Vec2<B::S>> Force<B> for PerBody<F> {
    const COUPLES: bool = false;

    #[inline]
    fn field<H: TimeStep<B::S>>(&mut self, now: &Now<H>, seen: &B, live: &mut B) {
        let force = (self.0)(now.time(), seen);
        let per_mass = B::S::product(now.step.coef(), seen.inv_mass().into());
        live.kick_by(force, per_mass);
    }
}
