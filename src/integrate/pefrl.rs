//! PEFRL, the position-extended method of Forest-Ruth type: order 4 for orbits.
//!
//! ```text
//! x += ξ h v    v += (1/2 - λ) h a    x += χ h v    v += λ h a    x += (1 - 2 (χ + ξ)) h v
//! v += λ h a    x += χ h v    v += (1/2 - λ) h a    x += ξ h v
//!
//! ξ = 0.1786178958448091   λ = -0.2123418310626054   χ = -0.06626458266981849
//! ```
//!
//! It is symplectic: energy does not drift. It is its own mirror image: negate every velocity, run the same ticks
//! backwards, and in fixed point every bit returns.
//!
//! A kick takes a share of the step; two shares are negative. Forces see a share as a step of that length and round once.
//! To multiply `h a` by a share instead needs a copy of the bodies and rounds twice. For a constant force both roundings
//! repeat in every step: in `I16F16` gravity can then be wrong by 1e-4. As it is, gravity keeps its fraction.
//!
//! Order 4 for forces that depend on position alone. Order 2 if they depend on time: all four calls see the middle of the
//! step. Order 1 if they depend on velocity, as explicit drag does; exact drag makes it 2 ·
//! four force calls · no bodies copied · stable for `h ω < 2.989`, explicit drag for `k h / m < 2.341` ·
//! not with contacts · reversible
//!
//! It rounds x five times a step: a body at constant velocity drifts up to five times as far as with
//! semi-implicit Euler.
//! Source: Omelyan, Mryglod, Folk, "Optimized Forest-Ruth- and Suzuki-like algorithms for integration
//! of motion in many-body systems", Comput. Phys. Commun. 146 (2002), arXiv:cond-mat/0110585.

use super::{Method, Rewinds, damp, each, kick, parabola};
use crate::body::id::BodyId;
use crate::body::{Body, Reverse};
use crate::force::{Force, Part, PerStep};
use crate::ratio::Ratio;
use crate::scalar::{Factor, Scalar};
use crate::time::{Between, Now, TimeStep};
use crate::vec2::Vec2;

/// The method for orbits, and for anything else without friction that must stay in phase for long.
///
/// A force is called four times a step, each time for a share of it. So a force of yours must take `h` from `now.step`,
/// and products with `h` from [`PerStep`], as the forces of this crate do. All four calls see one instant.
///
/// ```
/// use fixstep::{dec, vec2, AllPairs, Pefrl, Point, Pull, Step, World};
/// let mut world = World::<Point<f64>, 2>::new();
/// world.add(Point::new(vec2(-1, 0)?, vec2(0, dec!(-0.5))?, 1)?)?;
/// world.add(Point::new(vec2(1, 0)?, vec2(0, dec!(0.5))?, 1)?)?;
/// let mut pull = AllPairs(Pull::new(1, dec!(0.001))?);
/// let (mut pefrl, step) = (Pefrl::new(), Step::hz(5)?);
/// for _ in 0..1000 {
///     world.step(&mut pefrl, &mut pull, &step); // a circle, 63 steps a turn
/// }
/// let apart = world.bodies()[0].position() - world.bodies()[1].position();
/// assert!((apart.length() - 2.0).abs() < 2e-5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Pefrl<S: Scalar> {
    per_step: PerStep<S, Shares<S>>,
}

impl<S: Scalar> Pefrl<S> {
    /// Ready for any step.
    #[must_use]
    pub const fn new() -> Self {
        Pefrl {
            per_step: PerStep::new(),
        }
    }
}

impl<S: Scalar> Default for Pefrl<S> {
    fn default() -> Self {
        Self::new()
    }
}

/// What each drift and each kick takes of `h`, from the ends of the step to its middle.
#[derive(Clone, Copy, Debug)]
struct Shares<S: Scalar> {
    drifts: [S::Coef; 3],
    kicks: [S::Coef; 2],
}

// In units of 10^-17.
const XI: i64 = 17_861_789_584_480_910;
const LAMBDA: i64 = -21_234_183_106_260_540;
const CHI: i64 = -6_626_458_266_981_849;
const ONE: i64 = 100_000_000_000_000_000;

/// A share as a coefficient: inlined, or it would be divided at run time.
#[inline(always)]
fn part<S: Scalar>(num: i64) -> S::Coef {
    let part = Ratio::new(num, ONE as u64).ok().and_then(S::Coef::new);
    part.unwrap_or(S::ZERO.coef())
}

impl<S: Scalar> Shares<S> {
    fn of(h: S::Coef) -> Self {
        let drifts = [
            part::<S>(XI),
            part::<S>(CHI),
            part::<S>(ONE - 2 * (CHI + XI)),
        ];
        let kicks = [part::<S>(ONE / 2 - LAMBDA), part::<S>(LAMBDA)];
        Shares {
            drifts: drifts.map(|part| S::product(part, h)),
            kicks: kicks.map(|part| S::product(part, h)),
        }
    }
}

/// A share of a step as a step: its `h` is the share's, its clock that of the whole.
#[derive(Clone, Copy, Debug)]
struct Share<S: Scalar, H> {
    whole: H,
    coef: S::Coef,
}

impl<S: Scalar, H: TimeStep<S>> TimeStep<S> for Share<S, H> {
    #[inline]
    fn coef(&self) -> S::Coef {
        self.coef
    }

    #[inline]
    fn times(&self, rate: S) -> S {
        self.coef.scale(rate)
    }

    #[inline]
    fn half_times(&self, rate: S) -> S {
        self.times(rate).dyadic(1, 1)
    }

    #[inline]
    fn seconds(&self) -> Ratio {
        self.whole.seconds()
    }

    #[inline]
    fn at(&self, tick: u64) -> Self {
        Share {
            whole: self.whole.at(tick),
            ..*self
        }
    }
}

impl<B: Body, const N: usize> Method<B, N> for Pefrl<B::S> {
    #[inline]
    fn step<F: Force<B>, H: TimeStep<B::S>>(
        &mut self,
        ids: &[BodyId],
        bodies: &mut [B],
        forces: &mut F,
        step: &H,
        tick: u64,
    ) {
        const { assert!(!F::FLOWS, "a flow needs a method of order 2 or less") };
        let Shares { drifts, kicks } = self.per_step.get(step, Shares::of);
        let [outer, inner, middle] = drifts;
        let now = Now::middle(step, tick);
        forces.prepare(&now);
        damp(bodies, forces, &now, Part::FirstHalf);

        let stages = [
            (outer, kicks[0]),
            (inner, kicks[1]),
            (middle, kicks[1]),
            (inner, kicks[0]),
        ];
        for (share, coef) in stages {
            drift_by(bodies, share);
            let whole = *step;
            kick(
                ids,
                bodies,
                forces,
                &Now::middle(&Share { whole, coef }, tick),
            );
        }
        drift_by(bodies, outer);

        forces.prepare(&now);
        damp(bodies, forces, &now, Part::SecondHalf);
    }

    #[inline]
    fn between(&self, part: &Between<B::S>, before: &B, after: &B) -> Vec2<B::S> {
        parabola(part, before, after)
    }
}

// The stages are the same from both ends, and its forces act at one instant.
impl<B: Reverse, const N: usize> Rewinds<B, N> for Pefrl<B::S> {}

/// `x += share v` for every body; its angle moves by the same share.
#[inline]
fn drift_by<B: Body>(bodies: &mut [B], share: <B::S as Scalar>::Coef) {
    each(bodies, |body| {
        body.drift_by(share);
        body.drift_angle_by(share);
    });
}
