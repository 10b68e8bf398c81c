//! A spring with damper between one body and a fixed point: `F = -k (x - a) - c v`.
//!
//! Its rest length is zero, so the two axes do not mix and no square root is needed.

use crate::body::Body;
use crate::body::id::{self, BodyId};
use crate::error::Error;
use crate::force::{Force, Frame, PerStep, Reversible, coefficient, is_none};
use crate::ratio::Ratio;
use crate::scalar::{Factor, Scalar};
use crate::time::{Now, TimeStep};
use crate::vec2::Vec2;

/// Draws one body to a point and damps its motion. Does nothing once the body is gone.
///
/// ```
/// use fixstep::prelude::*;
/// let mut world = World::<Point<f32>, 1>::new();
/// let lamp = world.add(Point::new(vec2(1, 0)?, vec2(0, 0)?, 2)?)?;
/// let mut anchor = Anchor::new(lamp, vec2(0, 0)?, 50, 0)?; // 50 N/m at 1 m, 2 kg: 25 m/s²
/// world.step(&mut SemiImplicitEuler, &mut anchor, &Step::hz(50)?);
/// assert!((world.get(lamp)?.velocity().x + 0.5).abs() < 1e-6); // after 1/50 s
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Anchor<S: Scalar> {
    body: BodyId,
    point: Vec2<S>,
    stiffness: S::Coef,
    damping: S::Coef,
    per_step: PerStep<S, (S::Coef, S::Coef)>,
}

impl<S: Scalar> Anchor<S> {
    /// Ties `body` to `point` (m) with `stiffness` (N/m) and `damping` (kg/s), neither negative.
    /// Refuses values that the scalar's coefficients cannot hold.
    #[inline]
    pub fn new(
        body: BodyId,
        point: Vec2<S>,
        stiffness: impl Into<Ratio>,
        damping: impl Into<Ratio>,
    ) -> Result<Anchor<S>, Error> {
        let stiffness = coefficient::<S>("stiffness", stiffness.into())?;
        let damping = coefficient::<S>("damping", damping.into())?;
        Ok(Anchor {
            body,
            point,
            stiffness,
            damping,
            per_step: PerStep::new(),
        })
    }
}

impl<B: Body> Force<B> for Anchor<B::S> {
    const COUPLES: bool = true;

    #[inline]
    fn couple<H: TimeStep<B::S>>(&mut self, now: &Now<H>, frame: &mut Frame<B>) {
        let Some((index, body)) = frame.find(self.body) else {
            return;
        };
        let (stiffness, damping) = self.per_step.get(&now.step, |h| {
            (
                B::S::product(self.stiffness, h),
                B::S::product(self.damping, h),
            )
        });
        let inv_mass = body.inv_mass().into();
        let Some(live) = frame.live_at(index) else {
            return;
        };
        let pull = self.point - body.position();
        live.kick_by(pull, B::S::product(stiffness, inv_mass));
        live.brake_by(body.velocity(), B::S::product(damping, inv_mass));
    }

    fn potential(&self, ids: &[BodyId], bodies: &[B]) -> f64 {
        let Some(body) = id::position(ids, self.body).and_then(|i| bodies.get(i)) else {
            return 0.0;
        };
        let (x, a) = (body.position().to_f64(), self.point.to_f64());
        let square = (x.x - a.x) * (x.x - a.x) + (x.y - a.y) * (x.y - a.y);
        0.5 * self.stiffness.to_f64() * square
    }
}

impl<B: Body> Reversible<B> for Anchor<B::S> {
    fn damper(&self, _tick: u64) -> Option<&'static str> {
        (!is_none::<B::S>(self.damping)).then_some("Anchor")
    }
}
