//! Semi-implicit (symplectic) Euler: kick, then drift.
//!
//! ```text
//! v' = v + h a(x)
//! x' = x + h v'        (the new velocity)
//! ```
//!
//! Order 1 · one force call · no extra state · stable for `h ω < 2` · may be used with contacts
//!
//! Keeps `v² + ω² x² - h ω² x v` of an undamped spring, so its energy stays bounded.
//! Free fall comes out `g T h / 2` too far along g.
//! Source: Hairer, Lubich, Wanner, "Geometric numerical integration illustrated by the Störmer-Verlet
//! method", Acta Numerica 12 (2003), section 1.

use super::{Method, Rewinds, advance, drift, each_whole, kick};
use crate::body::id::BodyId;
use crate::body::{Body, Reverse};
use crate::force::{Force, Frame, Part, Reversible};
use crate::time::{Now, TimeStep};

/// Semi-implicit Euler: the cheapest method that is stable for springs.
///
/// ```
/// use fixstep::prelude::*;
/// let mut world = World::<Point<f64>, 1>::new();
/// let ball = world.add(Point::new(vec2(0, 0)?, vec2(0, 0)?, 1)?)?;
/// for _ in 0..64 {
///     world.step(&mut SemiImplicitEuler, &mut GravityY::new(-8)?, &Step::hz(64)?);
/// }
/// assert_eq!(world.get(ball)?.position().y, -4.0 - 8.0 / 128.0); // long by g t h / 2
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SemiImplicitEuler;

impl<B: Body, const N: usize> Method<B, N> for SemiImplicitEuler {
    #[inline]
    fn step<F: Force<B>, H: TimeStep<B::S>>(
        &mut self,
        ids: &[BodyId],
        bodies: &mut [B],
        forces: &mut F,
        step: &H,
        tick: u64,
    ) {
        let now = Now::start(step, tick);
        forces.prepare(&now);
        forces.couple(&now, &mut Frame::new(ids, bodies));
        each_whole(bodies, |body| {
            let seen = *body;
            forces.field(&now, &seen, body);
            forces.damp(&now, Part::Whole, body);
            if !F::FLOWS {
                body.drift(&now.step);
            }
        });
        if F::FLOWS {
            advance::<_, _, _, N>(ids, bodies, forces, &now, Part::Whole);
        }
    }
}

// Kick, drift is undone by its adjoint: drift, kick.
impl<B: Reverse, const N: usize> Rewinds<B, N> for SemiImplicitEuler {
    fn retrace<F: Reversible<B>, H: TimeStep<B::S>>(
        &mut self,
        ids: &[BodyId],
        bodies: &mut [B],
        forces: &mut F,
        step: &H,
        tick: u64,
    ) {
        let now = Now::start(step, tick);
        drift(bodies, &now);
        kick(ids, bodies, forces, &now);
    }
}
