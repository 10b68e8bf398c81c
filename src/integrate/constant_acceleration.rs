//! The step for constant acceleration, Eq. 3 to 5 of the article.
//!
//! ```text
//! v' = v + h a(x, v, t)
//! x' = x + h v + h²/2 a = x + h/2 (v + v')
//! ```
//!
//! Exact for constant force, else order 1 in v · one force call · a copy of the bodies where
//! forces couple them · a spring gains about `(h ω)²/4` in amplitude each step, at every h
//!
//! Differs from [`Verlet`](super::Verlet) in one thing: forces are taken at the start of the step.
//! Source: Hecker, "Physics, The Next Frontier" (1996), Eq. 3, 4 and 5.

use super::seen::{Seen, holds_a_copy};
use super::{Method, each, parabola};
use crate::body::Body;
use crate::body::id::BodyId;
use crate::force::{Force, Frame, Part};
use crate::time::{Between, Now, TimeStep};
use crate::vec2::Vec2;

/// Eq. 3 to 5 for worlds of `N` bodies; all forces act from the same instant.
///
/// ```
/// use fixstep::{ConstantAcceleration, prelude::*};
/// let mut world = World::<Point<f64>, 1>::new();
/// let ball = world.add(Point::new(vec2(0, 0)?, vec2(0, 0)?, 1)?)?;
/// let mut method = ConstantAcceleration::new();
/// for _ in 0..64 {
///     world.step(&mut method, &mut GravityY::new(-8)?, &Step::hz(64)?);
/// }
/// assert_eq!(world.get(ball)?.position().y, -4.0); // g t² / 2, exactly
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct ConstantAcceleration<B, const N: usize> {
    seen: Seen<B, N>,
}

holds_a_copy!(ConstantAcceleration);

impl<B: Body, const N: usize> Method<B, N> for ConstantAcceleration<B, N> {
    #[inline]
    fn step<F: Force<B>, H: TimeStep<B::S>>(
        &mut self,
        ids: &[BodyId],
        bodies: &mut [B],
        forces: &mut F,
        step: &H,
        tick: u64,
    ) {
        const { assert!(!F::FLOWS, "a flow needs a splitting method") };
        let now = Now::start(step, tick);
        forces.prepare(&now);
        if F::COUPLES {
            self.seen.copy(bodies);
        }
        each(bodies, |body| {
            let seen = *body;
            body.drift_half(&now.step);
            forces.damp(&now, Part::FirstHalf, body);
            forces.field(&now, &seen, body);
            if !F::COUPLES {
                forces.damp(&now, Part::SecondHalf, body);
                body.drift_half(&now.step);
            }
        });
        if F::COUPLES {
            forces.couple(&now, &mut Frame::split(ids, self.seen.bodies(), bodies));
            each(bodies, |body| {
                forces.damp(&now, Part::SecondHalf, body);
                body.drift_half(&now.step);
            });
        }
    }

    #[inline]
    fn between(&self, part: &Between<B::S>, before: &B, after: &B) -> Vec2<B::S> {
        parabola(part, before, after)
    }
}
