//! Quadratic drag as a force, `F = -c |v| v`: air at the speed of a ball.
//!
//! Explicit, so it overshoots: monotone for `c |v| h / m < 1`, unstable from 2, where each step makes
//! the body faster than it was. A body that falls with gravity g has the terminal speed `sqrt(m g / c)`. The speed
//! converges to it while `c |v| h / m < 1` there, and oscillates about it just beyond.

use crate::body::Body;
use crate::error::Error;
use crate::force::{Force, PerStep, coefficient};
use crate::ratio::Ratio;
use crate::scalar::Scalar;
use crate::time::{Now, TimeStep};

/// A force against the velocity and in proportion to its square, on every body.
///
/// ```
/// use fixstep::{QuadraticDrag, prelude::*};
/// let mut world = World::<Point<f64>, 1>::new();
/// let ball = world.add(Point::new(vec2(0, 0)?, vec2(30, 0)?, dec!(0.4))?)?;
/// // A football: half the density of air times cross-section times drag coefficient.
/// let mut drag = QuadraticDrag::new(dec!(0.0058))?;
/// world.step(&mut SemiImplicitEuler, &mut drag, &Step::hz(60)?);
/// let exact = 30.0 - 0.0058 * 30.0 * 30.0 / 0.4 / 60.0; // v - c |v| v h / m
/// assert!((world.get(ball)?.velocity().x - exact).abs() < 1e-12);
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct QuadraticDrag<S: Scalar> {
    drag: S::Coef,
    per_step: PerStep<S, S::Coef>,
    impulse: S::Coef,
}

impl<S: Scalar> QuadraticDrag<S> {
    /// `drag` in kg/m, not negative. Refuses a value that the scalar's coefficients cannot hold.
    #[inline]
    pub fn new(drag: impl Into<Ratio>) -> Result<QuadraticDrag<S>, Error> {
        let drag = coefficient::<S>("drag", drag.into())?;
        Ok(QuadraticDrag {
            drag,
            per_step: PerStep::new(),
            impulse: drag,
        })
    }
}

impl<B: Body> Force<B> for QuadraticDrag<B::S> {
    const COUPLES: bool = false;

    #[inline]
    fn prepare<H: TimeStep<B::S>>(&mut self, now: &Now<H>) {
        let product = |h| B::S::product(self.drag, h);
        self.impulse = self.per_step.get(&now.step, product);
    }

    // The speed joins the coefficient, so that the change of velocity is rounded once.
    #[inline]
    fn field<H: TimeStep<B::S>>(&mut self, _now: &Now<H>, seen: &B, live: &mut B) {
        let per_mass = B::S::product(self.impulse, seen.inv_mass().into());
        let velocity = seen.velocity();
        let factor = B::S::product(per_mass, velocity.length().coef());
        live.brake_by(velocity, factor);
    }
}
