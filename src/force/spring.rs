//! A spring with damper between two bodies.
//!
//! ```text
//! d = x2 - x1,  L = |d|
//! j = k h (L - L0) + c h (v2 - v1)·d / L      impulse along d
//! J = j d / L                                 added to body 1, taken from body 2
//! ```
//!
//! One impulse, used twice: the two sum to zero to the bit. Where the bodies coincide the
//! direction is unknown and the spring waits.

use crate::body::Body;
use crate::error::Error;
use crate::force::{Force, Frame, PerStep, coefficient};
use crate::id::{self, BodyId};
use crate::ratio::Ratio;
use crate::scalar::{Factor, Scalar};
use crate::step::TimeStep;
use crate::time::Now;
use crate::vec2::Vec2;

/// Draws two bodies to a distance and damps their motion along the line between them. Does
/// nothing once one of them is gone.
#[derive(Clone, Copy, Debug)]
pub struct Spring<S: Scalar> {
    bodies: [BodyId; 2],
    rest_length: S,
    stiffness: S::Coef,
    damping: S::Coef,
    per_step: PerStep<S, (S::Coef, S::Coef)>,
}

impl<S: Scalar> Spring<S> {
    /// Ties two bodies with `rest_length` (m), `stiffness` (N/m) and `damping` (kg/s), none
    /// negative. Refuses values that the scalar or its coefficients cannot hold.
    #[inline]
    pub fn new(
        bodies: [BodyId; 2],
        rest_length: impl Into<Ratio>,
        stiffness: impl Into<Ratio>,
        damping: impl Into<Ratio>,
    ) -> Result<Spring<S>, Error> {
        let (field, value) = ("rest_length", rest_length.into());
        if value.num() < 0 {
            return Err(Error::Negative { field, value });
        }
        let rest_length = S::ratio(value).ok_or(Error::OutOfRange { field, value })?;
        let stiffness = coefficient::<S>("stiffness", stiffness.into())?;
        let damping = coefficient::<S>("damping", damping.into())?;
        Ok(Spring {
            bodies,
            rest_length,
            stiffness,
            damping,
            per_step: PerStep::new(),
        })
    }

    /// The impulse on the first body over one step.
    #[inline]
    fn impulse<B, H>(&mut self, step: &H, first: &B, second: &B) -> Vec2<S>
    where
        B: Body<S = S>,
        H: TimeStep<S>,
    {
        let (stiffness, damping) = self.per_step.get(step, |h| {
            (S::product(self.stiffness, h), S::product(self.damping, h))
        });
        let along = second.position() - first.position();
        let length = along.length();
        let closing = length.under((second.velocity() - first.velocity()).dot(along));
        let pull = stiffness.of(length.minus(self.rest_length));
        along.with_length(pull.plus(damping.of(closing)), length)
    }
}

impl<B: Body> Force<B> for Spring<B::S> {
    const COUPLES: bool = true;

    #[inline]
    fn couple<H: TimeStep<B::S>>(&mut self, now: &Now<H>, frame: &mut Frame<B>) {
        let [first, second] = self.bodies.map(|id| frame.find(id));
        let (Some((i, first)), Some((j, second))) = (first, second) else {
            return;
        };
        let impulse = self.impulse(&now.step, &first, &second);
        if let Some(live) = frame.live_at(i) {
            live.push(impulse);
        }
        if let Some(live) = frame.live_at(j) {
            live.push(-impulse);
        }
    }

    fn potential(&self, ids: &[BodyId], bodies: &[B]) -> f64 {
        let find = |id| id::position(ids, id).and_then(|i| bodies.get(i));
        let [Some(first), Some(second)] = self.bodies.map(find) else {
            return 0.0;
        };
        let (a, b) = (first.position().to_f64(), second.position().to_f64());
        let stretch = (b - a).length() - self.rest_length.to_f64();
        0.5 * self.stiffness.to_f64() * stretch * stretch
    }
}
