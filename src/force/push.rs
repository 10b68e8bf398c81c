//! A constant force on one body: a thruster, a motor, a hand.
//!
//! In fixed point `F h / m` seldom fits the type. As with gravity its fraction is spread over the
//! ticks. So the velocity gained in n steps is `n h F / m` rounded once.

use crate::body::Body;
use crate::body::id::{self, BodyId};
use crate::force::{Force, Frame, Reversible};
use crate::scalar::Scalar;
use crate::time::{Now, TimeStep};
use crate::vec2::Vec2;

/// Pushes one body with the same force in every step. Does nothing once the body is gone.
///
/// ```
/// use fixstep::{Window, prelude::*};
/// let mut world = World::<Point<f32>, 1>::new();
/// let rocket = world.add(Point::new(vec2(0, 0)?, vec2(0, 0)?, 20)?)?;
/// // Burns in the steps 0 to 119: two seconds at 60 Hz.
/// let mut burn = Window::new(0..120, Push::new(rocket, vec2(0, 300)?));
/// for _ in 0..200 {
///     world.step(&mut SemiImplicitEuler, &mut burn, &Step::hz(60)?);
/// }
/// assert!((world.get(rocket)?.velocity().y - 30.0).abs() < 1e-3); // F t / m
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Push<S> {
    /// The body that is pushed.
    pub body: BodyId,
    /// The force, N.
    pub force: Vec2<S>,
}

impl<S: Scalar> Push<S> {
    /// `force` in N.
    #[inline]
    #[must_use]
    pub const fn new(body: BodyId, force: Vec2<S>) -> Push<S> {
        Push { body, force }
    }
}

impl<B: Body> Force<B> for Push<B::S> {
    const COUPLES: bool = true;

    #[inline]
    fn couple<H: TimeStep<B::S>>(&mut self, now: &Now<H>, frame: &mut Frame<B>) {
        let Some((index, body)) = frame.find(self.body) else {
            return;
        };
        let per_mass = B::S::product(now.step.coef(), body.inv_mass().into());
        let gain = |force: B::S| B::S::gained(force.gain(per_mass), now.tick());
        if let Some(live) = frame.live_at(index) {
            live.kick(self.force.map(gain));
        }
    }

    fn potential(&self, ids: &[BodyId], bodies: &[B]) -> f64 {
        let body = id::position(ids, self.body).and_then(|i| bodies.get(i));
        body.map_or(0.0, |body| {
            -self.force.to_f64().dot(body.position().to_f64())
        })
    }
}

impl<B: Body> Reversible<B> for Push<B::S> {}
