//! Euler's method, as the article has it.
//!
//! ```text
//! x' = x + h v          (the old velocity)
//! v' = v + h a(x, v, t)
//! ```
//!
//! Order 1 · one force call · a copy of the bodies where forces couple them · a spring gains
//! `sqrt(1 + (h ω)²)` in amplitude each step, at every h · drag is monotone for `k h / m < 1`
//!
//! Free fall comes out `g T h / 2` short along g. For teaching, and as the worst line of a chart.
//! Source: Hecker, "Physics, The Next Frontier" (1996).

use super::seen::{Seen, holds_a_copy};
use super::{Method, each};
use crate::body::Body;
use crate::body::id::BodyId;
use crate::force::{Force, Frame, Part};
use crate::time::{Now, TimeStep};

/// Explicit Euler for worlds of `N` bodies; all forces act from the same instant.
///
/// ```
/// use fixstep::{Euler, prelude::*};
/// let mut world = World::<Point<f64>, 1>::new();
/// let ball = world.add(Point::new(vec2(0, 0)?, vec2(0, 0)?, 1)?)?;
/// let mut method = Euler::new();
/// for _ in 0..64 {
///     world.step(&mut method, &mut GravityY::new(-8)?, &Step::hz(64)?);
/// }
/// assert_eq!(world.get(ball)?.position().y, -4.0 + 8.0 / 128.0); // short by g t h / 2
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Euler<B, const N: usize> {
    seen: Seen<B, N>,
}

holds_a_copy!(Euler);

impl<B: Body, const N: usize> Method<B, N> for Euler<B, N> {
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
            body.drift(&now.step);
            forces.field(&now, &seen, body);
            if !F::COUPLES {
                forces.damp(&now, Part::Whole, body);
            }
        });
        if F::COUPLES {
            forces.couple(&now, &mut Frame::split(ids, self.seen.bodies(), bodies));
            each(bodies, |body| forces.damp(&now, Part::Whole, body));
        }
    }
}
