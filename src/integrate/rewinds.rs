//! Methods whose steps can be undone, to the bit.
//!
//! ```text
//! v := -v,   the stages of the step in the opposite order,   v := -v
//! ```
//!
//! Why this restores every bit: drift and product are odd, so `x + d(v) + d(-v) = x` whatever was rounded.
//! Kicks depend on positions and time alone, so `-(v + a) + a = -v`. The sums lose nothing.
//!
//! The stages use the number of the tick that is undone. The fractions of gravity depend on it, and so do *spans*:
//! two roundings of `h`, one just below and one just above, used alternately.
//!
//! Source: Rein, Tamayo, "JANUS: a bit-wise reversible integrator for N-body dynamics", MNRAS 473
//! (2018), arXiv:1704.07715: state on a grid of integers, any rounding of the kicks. The same for the
//! Verlet of molecular dynamics: Levesque, Verlet, "Molecular dynamics and time reversibility", J.
//! Stat. Phys. 72 (1993).

use super::{Method, each};
use crate::body::Reverse;
use crate::body::id::BodyId;
use crate::force::Reversible;
use crate::time::TimeStep;

/// A method that can undo a step.
///
/// ```
/// use fixstep::{RangeChecked, fixed::types::I16F16, prelude::*};
/// let mut world = World::<RangeChecked<Point<I16F16>>, 1>::new();
/// world.add(RangeChecked::new(Point::new(vec2(0, 9)?, vec2(3, 0)?, 1)?))?;
/// let (before, mut gravity, step) = (world.state_hash(), GravityY::new(-8)?, Step::hz(60)?);
/// (0..100).for_each(|_| world.step(&mut Verlet, &mut gravity, &step));
/// for _ in 0..100 {
///     world.step_back(&mut Verlet, &mut gravity, &step).unwrap();
/// }
/// assert_eq!(world.state_hash(), before);
/// # Ok::<(), fixstep::Error>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot undo a step",
    note = "`Verlet`, `Pefrl` and `SemiImplicitEuler` can"
)]
pub trait Rewinds<B: Reverse, const N: usize>: Method<B, N> {
    /// The stages of a step in the opposite order, on bodies whose velocities were reversed. That is the step
    /// itself for a method that is the same from both ends, and whose forces all act at one instant.
    #[inline]
    fn retrace<F: Reversible<B>, H: TimeStep<B::S>>(
        &mut self,
        ids: &[BodyId],
        bodies: &mut [B],
        forces: &mut F,
        step: &H,
        tick: u64,
    ) {
        self.step(ids, bodies, forces, step, tick);
    }

    /// Moves `bodies` from the end of step `tick` to its start. Does not test for saturation:
    /// [`World::step_back`](crate::World::step_back) does.
    #[inline]
    fn step_back<F: Reversible<B>, H: TimeStep<B::S>>(
        &mut self,
        ids: &[BodyId],
        bodies: &mut [B],
        forces: &mut F,
        step: &H,
        tick: u64,
    ) {
        each(bodies, B::reverse);
        self.retrace(ids, bodies, forces, step, tick);
        each(bodies, B::reverse);
    }
}
