//! Drag against the spin, `M = -c ω`, as an exact factor: `s' = s exp(-c h / I)`.
//!
//! No limit on `c h / I`. With the units of the crate `c / I = 2π c · 1 / 2πI`.

use crate::error::Error;
use crate::force::{Force, Memo, Part, PerStep, coefficient, half};
use crate::ratio::Ratio;
use crate::rigid::Rotating;
use crate::scalar::{Angular, Decay, Scalar};
use crate::time::{Now, TimeStep};

/// A torque against the spin and in proportion to it, on every rigid body: a bearing, or air.
///
/// As with [`ExactDrag`](crate::ExactDrag) the factor is computed again where a body has another inertia than the one
/// before it. In fixed point a spin loses a unit or more in each part of a step, so it comes to rest. A *carried* body
/// keeps what rounding loses and has no such limit.
///
/// Beside a motor it is no longer exact. With `x = c h / I` the final spin is `x / (exp(x) - 1)` of `M / c` with
/// `SemiImplicitEuler`, and `(x/2) / sinh(x/2)` of it with `Verlet`.
///
/// ```
/// use fixstep::{dec, rigid::torque::SpinDrag, vec2, Point, Rigid, SemiImplicitEuler, Step, World};
/// let centre = Point::<f32>::new(vec2(0, 0)?, vec2(0, 0)?, 1)?;
/// let mut world = World::<_, 1>::new();
/// let wheel = world.add(Rigid::new(centre, 2)?.with_spin(1)?)?;
/// let mut bearing = SpinDrag::new(dec!(0.5))?; // a time constant of I / c = 4 s
/// for _ in 0..240 {
///     world.step(&mut SemiImplicitEuler, &mut bearing, &Step::hz(60)?);
/// }
/// assert!((world.get(wheel)?.spin() - (-1.0_f32).exp()).abs() < 1e-5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct SpinDrag<S: Scalar> {
    drag: S::Coef,
    per_step: PerStep<S, S::Coef>,
    rate: S::Coef,
    /// What is lost in a step or in half of it, by inverse inertia.
    loss: Memo<(S::Coef, bool), S::Coef>,
}

impl<S: Decay + Angular> SpinDrag<S> {
    /// `drag` in N m s per radian, not negative. Refuses a value that the scalar's coefficients cannot
    /// hold.
    #[inline]
    pub fn new(drag: impl Into<Ratio>) -> Result<SpinDrag<S>, Error> {
        let drag = coefficient::<S>("drag", drag.into())?;
        Ok(SpinDrag {
            drag,
            per_step: PerStep::new(),
            rate: drag,
            loss: Memo::new(),
        })
    }
}

impl<B: Rotating<S: Decay + Angular>> Force<B> for SpinDrag<B::S> {
    const COUPLES: bool = false;

    #[inline]
    fn prepare<H: TimeStep<B::S>>(&mut self, now: &Now<H>) {
        let product = |h| B::S::product(B::S::product(self.drag, h), B::S::TAU);
        let rate = self.per_step.get(&now.step, product);
        if rate != self.rate {
            self.rate = rate;
            self.loss.forget();
        }
    }

    #[inline]
    fn damp<H: TimeStep<B::S>>(&mut self, _now: &Now<H>, part: Part, live: &mut B) {
        let (inv_inertia, whole) = (live.inv_inertia(), part == Part::Whole);
        let loss = self.loss.get((inv_inertia, whole), |(inv_inertia, whole)| {
            let over = B::S::product(self.rate, inv_inertia);
            let [loss, ..] = B::S::decay(if whole { over } else { half::<B::S>(over) });
            loss
        });
        live.damp_spin(loss);
    }
}
