//! Euler's method, as the article has it.
//!
//! ```text
//! x' = x + h v          (the old velocity)
//! v' = v + h a(x, v, t)
//! ```
//!
//! Order 1 · one force call · a copy of the bodies where forces couple them · a spring gains
//! `sqrt(1 + (h ω)²)` in amplitude each step, at every h · drag is monotone for `k h / m < 1`
//! Free fall comes out `g T h / 2` short along g. For teaching, and as the worst line of a chart.
//! Source: Hecker, "Physics, The Next Frontier" (1996).

use super::seen::{Seen, holds_a_copy};
use super::{Method, each};
use crate::body::Body;
use crate::body::id::BodyId;
use crate::force::{Force, Frame, Part};
use crate::time::{Now, TimeStep};

/// Explicit Euler for worlds of `N` bodies; all forces act from the same instant.
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
