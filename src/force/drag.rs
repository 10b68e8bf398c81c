//! Linear drag as a force, `F = -k v`: what the article calls friction.
//!
//! Explicit, so it overshoots: monotone for `k h / m < 1`, unstable from `k h / m = 2`.
//! Source: Hecker, "Physics, The Next Frontier" (1996), Eq. 12.

use crate::body::Body;
use crate::error::Error;
use crate::force::{Force, PerStep, coefficient};
use crate::ratio::Ratio;
use crate::scalar::Scalar;
use crate::time::{Now, TimeStep};

/// A force against the velocity and in proportion to it, on every body.
///
/// ```
/// use fixstep::prelude::*;
/// let mut world = World::<Point<f32>, 1>::new();
/// let id = world.add(Point::new(vec2(0, 0)?, vec2(4, 0)?, 1)?)?;
/// let mut drag = LinearDrag::new(4)?;
/// world.step(&mut SemiImplicitEuler, &mut drag, &Step::hz(8)?);
/// assert_eq!(world.get(id)?.velocity(), vec2(2, 0)?); // k h / m is 1/2
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct LinearDrag<S: Scalar> {
    drag: S::Coef,
    per_step: PerStep<S, S::Coef>,
    impulse: S::Coef,
}

impl<S: Scalar> LinearDrag<S> {
    /// `drag` in kg/s, not negative. Refuses a value that the scalar's coefficients cannot hold.
    #[inline]
    pub fn new(drag: impl Into<Ratio>) -> Result<LinearDrag<S>, Error> {
        let drag = coefficient::<S>("drag", drag.into())?;
        Ok(LinearDrag {
            drag,
            per_step: PerStep::new(),
            impulse: drag,
        })
    }
}

impl<B: Body> Force<B> for LinearDrag<B::S> {
    const COUPLES: bool = false;

    #[inline]
    fn prepare<H: TimeStep<B::S>>(&mut self, now: &Now<H>) {
        self.impulse = self
            .per_step
            .get(&now.step, |h| B::S::product(self.drag, h));
    }

    #[inline]
    fn field<H: TimeStep<B::S>>(&mut self, _now: &Now<H>, seen: &B, live: &mut B) {
        let per_mass = B::S::product(self.impulse, seen.inv_mass().into());
        live.brake_by(seen.velocity(), per_mass);
    }
}
