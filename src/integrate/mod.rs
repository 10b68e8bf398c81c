//! Methods, and the stages they are made of.
//!
//! | method | order | force calls | extra state | stable for a spring | with contacts |
//! |---|---|---|---|---|---|
//! | [`Euler`] | 1 | 1 | a copy of the bodies | never | yes |
//! | [`ConstantAcceleration`] | 1; exact for constant force | 1 | a copy of the bodies | never | no |
//! | [`SemiImplicitEuler`] | 1 | 1 | none | `h ω < 2` | yes |
//! | [`Verlet`] | 2; exact for constant force | 1 | none | `h ω < 2` | no |
//!
//! [`kick`], [`damp`], [`drift`] and [`drift_half`] are free functions over slices: a scene that wants
//! another order calls them itself, with one [`Now`] for all stages of a step. A method that fuses
//! two of them gives the same bits.

mod constant_acceleration;
mod euler;
mod semi_implicit;
mod verlet;

use crate::between::Between;
use crate::body::Body;
use crate::force::{Force, Frame, Part};
use crate::id::BodyId;
use crate::step::TimeStep;
use crate::time::Now;
use crate::vec2::Vec2;

pub use constant_acceleration::ConstantAcceleration;
pub use euler::Euler;
pub use semi_implicit::SemiImplicitEuler;
pub use verlet::Verlet;

/// A way to make one step, for worlds of `N` bodies.
pub trait Method<B: Body, const N: usize> {
    /// Moves `bodies`, whose names are `ids`, from tick `tick` to the next.
    fn step<F: Force<B>, H: TimeStep<B::S>>(
        &mut self,
        ids: &[BodyId],
        bodies: &mut [B],
        forces: &mut F,
        step: &H,
        tick: u64,
    );

    /// Where a body was at a part of the step from `before` to `after`: on the straight line, for a
    /// method whose bodies keep one velocity through a step. A method that wraps another hands this on.
    #[inline]
    #[must_use]
    fn between(&self, part: &Between<B::S>, before: &B, after: &B) -> Vec2<B::S> {
        part.chord(before.position(), after.position())
    }
}

/// The path of a method with a constant acceleration in each step: a parabola.
#[inline]
fn parabola<B: Body>(part: &Between<B::S>, before: &B, after: &B) -> Vec2<B::S> {
    let change = after.velocity() - before.velocity();
    part.chord(before.position(), after.position()) + part.bow(change)
}

/// Stage: every force changes velocities; positions stay.
#[inline]
pub fn kick<B: Body, F: Force<B>, H: TimeStep<B::S>>(
    ids: &[BodyId],
    bodies: &mut [B],
    forces: &mut F,
    now: &Now<H>,
) {
    forces.prepare(now);
    forces.couple(now, &mut Frame::new(ids, bodies));
    each(bodies, |body| {
        let seen = *body;
        forces.field(now, &seen, body);
    });
}

/// Stage: `x += h v` for every body.
#[inline]
pub fn drift<B: Body, H: TimeStep<B::S>>(bodies: &mut [B], now: &Now<H>) {
    each(bodies, |body| body.drift(&now.step));
}

/// Stage: `x += h/2 v` for every body.
#[inline]
pub fn drift_half<B: Body, H: TimeStep<B::S>>(bodies: &mut [B], now: &Now<H>) {
    each(bodies, |body| body.drift_half(&now.step));
}

/// Stage: velocities lose what drags take from them in `part` of the step.
#[inline]
pub fn damp<B: Body, F: Force<B>, H: TimeStep<B::S>>(
    bodies: &mut [B],
    forces: &mut F,
    now: &Now<H>,
    part: Part,
) {
    each(bodies, |body| forces.damp(now, part, body));
}

/// Every body is moved through `part` of the step: by a flow that has it, else by its own drift.
#[inline]
fn advance<B: Body, F: Force<B>, H: TimeStep<B::S>, const N: usize>(
    ids: &[BodyId],
    bodies: &mut [B],
    forces: &mut F,
    now: &Now<H>,
    part: Part,
) {
    let mut moved = [false; N];
    if F::FLOWS {
        forces.flow(now, part, &mut Frame::new(ids, bodies), &mut moved);
    }
    let mut moved = moved.iter();
    each(bodies, |body| match part {
        _ if F::FLOWS && moved.next() == Some(&true) => {}
        Part::Whole => body.drift(&now.step),
        _ => body.drift_half(&now.step),
    });
}

/// Fills `seen` with the bodies, which it has room for.
#[inline]
fn copy<B: Body, const N: usize>(bodies: &[B], seen: &mut heapless::Vec<B, N>) {
    seen.clear();
    for &body in bodies {
        let _ = seen.push(body);
    }
}

/// `f` on every body. Counts bodies, not addresses: from a loop over addresses the compiler
/// divides by the size of a body before it unrolls, dear on a core that cannot divide.
#[inline(always)]
fn each<B>(bodies: &mut [B], mut f: impl FnMut(&mut B)) {
    let mut rest = bodies;
    while let Some((body, behind)) = rest.split_first_mut() {
        f(body);
        rest = behind;
    }
}
