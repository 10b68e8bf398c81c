//! Any function of time, of a body's own state and of all other bodies.
//!
//! All forces are computed before the first is applied, so no body sees another half-moved and
//! the order of the bodies does not matter. That takes 8 bytes a body, which live in the force.

use crate::body::Body;
use crate::force::{Force, Frame};
use crate::scalar::Scalar;
use crate::time::{Now, Time, TimeStep};
use crate::vec2::Vec2;

/// A force, in newtons, that `F` computes for each body from the time, all bodies and the index of the body.
/// For worlds of up to `N` bodies. For a torque implement [`Force`].
///
/// ```
/// use fixstep::{AllBodies, Time, prelude::*};
/// // Every body is drawn to the first one.
/// let mut pull = AllBodies::<_, f32, 2>::new(|_: Time, all: &[Point<f32>], i: usize| {
///     match (all.first(), all.get(i)) {
///         (Some(first), Some(body)) => first.position() - body.position(),
///         _ => Vec2::ZERO,
///     }
/// });
/// let mut world = World::<_, 2>::new();
/// world.add(Point::new(vec2(0, 0)?, vec2(0, 0)?, 1)?)?;
/// let far = world.add(Point::new(vec2(8, 0)?, vec2(0, 0)?, 1)?)?;
/// world.step(&mut SemiImplicitEuler, &mut pull, &Step::hz(8)?);
/// assert_eq!(world.get(far)?.velocity(), vec2(-1, 0)?); // 8 N for 1/8 s, 1 kg
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct AllBodies<F, S, const N: usize> {
    function: F,
    forces: [Vec2<S>; N],
}

impl<F, S: Scalar, const N: usize> AllBodies<F, S, N> {
    /// Bodies beyond the first `N` feel nothing: choose the capacity of the world.
    #[must_use]
    pub const fn new(function: F) -> Self {
        AllBodies {
            function,
            forces: [Vec2::ZERO; N],
        }
    }
}

impl<B: Body, F, const N: usize> Force<B> for AllBodies<F, B::S, N>
where
    F: FnMut(Time, &[B], usize) -> Vec2<B::S>,
{
    const COUPLES: bool = true;

    #[inline]
    fn couple<H: TimeStep<B::S>>(&mut self, now: &Now<H>, frame: &mut Frame<B>) {
        let bodies = frame.bodies();
        for (i, force) in self.forces.iter_mut().take(bodies.len()).enumerate() {
            *force = (self.function)(now.time(), bodies, i);
        }
        for (body, force) in frame.live().iter_mut().zip(&self.forces) {
            let per_mass = B::S::product(now.step.coef(), body.inv_mass().into());
            body.kick_by(*force, per_mass);
        }
    }
}
