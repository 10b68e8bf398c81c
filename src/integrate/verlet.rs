//! Verlet as drift-kick-drift (position Verlet, leapfrog).
//!
//! ```text
//! x½ = x  + h/2 v
//! v' = v  + h a(x½, t + h/2)
//! x' = x½ + h/2 v'
//! ```
//!
//! Order 2, exact for constant force · one force call · no extra state · stable for `h ω < 2`
//!
//! A force that depends on v makes it order 1: the kick sees the old velocity.
//!
//! Why this order of the three: kick-drift-kick needs two force calls, or keeps accelerations that go stale when a body is
//! teleported or added. Half-step velocities are not the velocities that a scene reads. Drift-kick-drift has neither
//! fault. It costs a second product per axis, and a second rounding of x. So a body at constant velocity drifts up to
//! twice as far as with semi-implicit Euler.
//!
//! Source: Hairer, Lubich, Wanner, "Geometric numerical integration illustrated by the Störmer-Verlet
//! method", Acta Numerica 12 (2003), section 1.

use super::{Method, Rewinds, advance, damp, each_whole, parabola};
use crate::body::id::BodyId;
use crate::body::{Body, Reverse};
use crate::force::{Force, Frame, Part};
use crate::time::{Between, Now, TimeStep};
use crate::vec2::Vec2;

/// Verlet, drift-kick-drift: the default for bodies that touch nothing.
///
/// ```
/// use fixstep::prelude::*;
/// let mut world = World::<Point<f64>, 1>::new();
/// let ball = world.add(Point::new(vec2(0, 0)?, vec2(0, 0)?, 1)?)?;
/// for _ in 0..64 {
///     world.step(&mut Verlet, &mut GravityY::new(-8)?, &Step::hz(64)?);
/// }
/// assert_eq!(world.get(ball)?.position().y, -4.0); // g t² / 2, exactly
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Verlet;

impl<B: Body, const N: usize> Method<B, N> for Verlet {
    #[inline]
    fn step<F: Force<B>, H: TimeStep<B::S>>(
        &mut self,
        ids: &[BodyId],
        bodies: &mut [B],
        forces: &mut F,
        step: &H,
        tick: u64,
    ) {
        let now = Now::middle(step, tick);
        forces.prepare(&now);
        let apart = F::COUPLES || F::FLOWS;
        if apart {
            advance::<_, _, _, N>(ids, bodies, forces, &now, Part::FirstHalf);
            damp(bodies, forces, &now, Part::FirstHalf);
            forces.couple(&now, &mut Frame::new(ids, bodies));
        }
        each_whole(bodies, |body| {
            if !apart {
                body.drift_half(&now.step);
                forces.damp(&now, Part::FirstHalf, body);
            }
            let seen = *body;
            forces.field(&now, &seen, body);
            forces.damp(&now, Part::SecondHalf, body);
            if !F::FLOWS {
                body.drift_half(&now.step);
            }
        });
        if F::FLOWS {
            advance::<_, _, _, N>(ids, bodies, forces, &now, Part::SecondHalf);
        }
    }

    #[inline]
    fn between(&self, part: &Between<B::S>, before: &B, after: &B) -> Vec2<B::S> {
        parabola(part, before, after)
    }
}

// Drift, kick, drift is the same from both ends, and its forces act at one instant.
impl<B: Reverse, const N: usize> Rewinds<B, N> for Verlet {}
