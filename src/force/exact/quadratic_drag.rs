//! Quadratic drag, solved exactly: `v' = v / (1 + c |v| h / m)`.
//!
//! A factor, not a force: velocities shrink and never change sign, at any speed. The explicit force makes a body faster
//! from `c |v| h / m = 2`.
//! Source: the exact solution of `m v' = -c |v| v`; the direction stays, and `1/|v|` grows by `c h / m`.

use crate::body::Body;
use crate::error::Error;
use crate::force::{Force, Part, PerStep, coefficient, half};
use crate::ratio::Ratio;
use crate::scalar::{Decay, Scalar};
use crate::time::{Now, TimeStep};

/// Drag in proportion to the square of the velocity, on every body, exact at any step.
///
/// In exact arithmetic it never brings a body to rest. In fixed point a body that keeps no remainders
/// loses a unit a step in the end, and comes to rest.
///
/// ```
/// use fixstep::{ExactQuadraticDrag, prelude::*};
/// let mut world = World::<Point<f64>, 1>::new();
/// let ball = world.add(Point::new(vec2(0, 0)?, vec2(30, 0)?, dec!(0.4))?)?;
/// // A football: half the density of air times cross-section times drag coefficient.
/// let mut drag = ExactQuadraticDrag::new(dec!(0.0058))?;
/// for _ in 0..60 {
///     world.step(&mut Verlet, &mut drag, &Step::hz(60)?);
/// }
/// let exact = 30.0 / (1.0 + 0.0058 * 30.0 / 0.4); // after 1 s
/// assert!((world.get(ball)?.velocity().x - exact).abs() < 1e-12);
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct ExactQuadraticDrag<S: Scalar> {
    drag: S::Coef,
    per_step: PerStep<S, [S::Coef; 2]>,
    rate: [S::Coef; 2],
}

impl<S: Decay> ExactQuadraticDrag<S> {
    /// `drag` in kg/m, not negative. Refuses a value that the scalar's coefficients cannot hold.
    #[inline]
    pub fn new(drag: impl Into<Ratio>) -> Result<ExactQuadraticDrag<S>, Error> {
        let drag = coefficient::<S>("drag", drag.into())?;
        Ok(ExactQuadraticDrag {
            drag,
            per_step: PerStep::new(),
            rate: [drag; 2],
        })
    }
}

impl<B: Body<S: Decay>> Force<B> for ExactQuadraticDrag<B::S> {
    const COUPLES: bool = false;

    #[inline]
    fn prepare<H: TimeStep<B::S>>(&mut self, now: &Now<H>) {
        self.rate = self.per_step.get(&now.step, |h| {
            let whole = B::S::product(self.drag, h);
            [whole, half::<B::S>(whole)]
        });
    }

    // The speed joins the coefficient, so that the change of velocity is rounded once.
    #[inline]
    fn damp<H: TimeStep<B::S>>(&mut self, _now: &Now<H>, part: Part, live: &mut B) {
        let [whole, half] = self.rate;
        let rate = if part == Part::Whole { whole } else { half };
        let per_mass = B::S::product(rate, live.inv_mass().into());
        let speed = live.velocity().length().coef();
        live.damp(B::S::share(B::S::product(per_mass, speed)));
    }
}
