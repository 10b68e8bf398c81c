//! Linear drag, solved exactly: `v' = v exp(-k h / m)`.
//!
//! A factor, not a force: velocities shrink and never change sign, however large `k h / m` is. Without other forces a body
//! follows the exact decay. Methods apply the factor beside their kicks. [`Verlet`] applies half before and half after, so
//! its order stays 2.
//! Source: the exact solution of `m v' = -k v`, the article's Eq. 12; the splitting is that of Strang,
//! as Leimkuhler, Matthews, Appl. Math. Res. eXpress 2013 (2013), "O" of BAOAB.
//!
//! [`Verlet`]: crate::integrate::Verlet

use crate::body::Body;
use crate::error::Error;
use crate::force::{Force, Memo, Part, PerStep, coefficient, half};
use crate::ratio::Ratio;
use crate::scalar::{Decay, Scalar};
use crate::time::{Now, TimeStep};

/// Drag in proportion to the velocity, on every body, exact at any step.
///
/// In fixed point a [`Point`](crate::Point) loses a unit of speed or more in each part of a step, so it comes to
/// rest. A smaller change of speed does not start it again. A [`Carried`](crate::Carried) has no such limit.
///
/// The factor depends on the mass. It is computed again where a body has another mass than the one before it.
/// If bodies of equal mass are added one after another, it is computed once.
///
/// ```
/// use fixstep::{dec, vec2, ExactDrag, Point, SemiImplicitEuler, Step, World};
/// let mut world = World::<_, 1>::new();
/// let id = world.add(Point::<f32>::new(vec2(0, 0)?, vec2(8, 0)?, 2)?)?;
/// let mut drag = ExactDrag::new(12_000)?; // k h / m is 100: the explicit force would explode
/// world.step(&mut SemiImplicitEuler, &mut drag, &Step::hz(60)?);
/// assert!(world.get(id)?.velocity().x < 1e-30);
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct ExactDrag<S: Scalar> {
    drag: S::Coef,
    per_step: PerStep<S, S::Coef>,
    rate: S::Coef,
    /// What is lost in a step or in half of it, by inverse mass.
    loss: Memo<(S::InvMass, bool), S::Coef>,
}

impl<S: Decay> ExactDrag<S> {
    /// `drag` in kg/s, not negative. Refuses a value that the scalar's coefficients cannot hold.
    #[inline]
    pub fn new(drag: impl Into<Ratio>) -> Result<ExactDrag<S>, Error> {
        let drag = coefficient::<S>("drag", drag.into())?;
        Ok(ExactDrag {
            drag,
            per_step: PerStep::new(),
            rate: drag,
            loss: Memo::new(),
        })
    }
}

impl<B: Body<S: Decay>> Force<B> for ExactDrag<B::S> {
    const COUPLES: bool = false;

    #[inline]
    fn prepare<H: TimeStep<B::S>>(&mut self, now: &Now<H>) {
        let product = |h| B::S::product(self.drag, h);
        let rate = self.per_step.get(&now.step, product);
        if rate != self.rate {
            self.rate = rate;
            self.loss.forget();
        }
    }

    #[inline]
    fn damp<H: TimeStep<B::S>>(&mut self, _now: &Now<H>, part: Part, live: &mut B) {
        let (inv_mass, whole) = (live.inv_mass(), part == Part::Whole);
        let loss = self.loss.get((inv_mass, whole), |(inv_mass, whole)| {
            let over = B::S::product(self.rate, inv_mass.into());
            let [loss, ..] = B::S::decay(if whole { over } else { half::<B::S>(over) });
            loss
        });
        live.damp(loss);
    }
}
