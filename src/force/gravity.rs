//! Uniform gravity: `dv = g h`, the same for every body.
//!
//! In fixed point `g h` seldom fits the type: at 60 Hz an `I16F16` would fall 1.3e-5 too slowly.
//! Its fraction is therefore spread over the ticks, so that the velocity gained in n steps is
//! `n g h` rounded once. That costs a few instructions a step and none a body.

use crate::body::Body;
use crate::body::id::BodyId;
use crate::error::Error;
use crate::force::{Force, PerStep, Reversible};
use crate::ratio::Ratio;
use crate::scalar::Scalar;
use crate::time::{Now, TimeStep};
use crate::vec2::Vec2;

/// The same acceleration for every body.
///
/// ```
/// use fixstep::prelude::*;
/// let mut world = World::<Point<f32>, 1>::new();
/// let id = world.add(Point::new(vec2(0, 0)?, vec2(3, 0)?, 1)?)?;
/// let mut gravity = Gravity::new(vec2(0, -8)?);
/// world.step(&mut SemiImplicitEuler, &mut gravity, &Step::hz(8)?);
/// assert_eq!(world.get(id)?.velocity(), vec2(3, -1)?); // 8 m/s² for 1/8 s
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Gravity<S: Scalar> {
    acceleration: Vec2<S>,
    gain: PerStep<S, Vec2<S::Gain>>,
    share: Vec2<S>,
}

impl<S: Scalar> Gravity<S> {
    /// `acceleration` in m/s².
    #[inline]
    #[must_use]
    pub fn new(acceleration: Vec2<S>) -> Gravity<S> {
        Gravity {
            acceleration,
            gain: PerStep::new(),
            share: Vec2::ZERO,
        }
    }
}

impl<B: Body> Force<B> for Gravity<B::S> {
    const COUPLES: bool = false;

    #[inline]
    fn prepare<H: TimeStep<B::S>>(&mut self, now: &Now<H>) {
        let gain = self
            .gain
            .get(&now.step, |h| self.acceleration.map(|g| g.gain(h)));
        self.share = Vec2 {
            x: B::S::gained(gain.x, now.tick()),
            y: B::S::gained(gain.y, now.tick()),
        };
    }

    #[inline]
    fn field<H: TimeStep<B::S>>(&mut self, _now: &Now<H>, _seen: &B, live: &mut B) {
        live.kick(self.share);
    }

    fn potential(&self, _ids: &[BodyId], bodies: &[B]) -> f64 {
        super::potential(self.acceleration, bodies)
    }
}

/// Gravity along y, the usual case: one addition a body instead of two.
///
/// ```
/// use fixstep::{fixed::types::I16F16, prelude::*};
/// let mut world = World::<Point<I16F16>, 1>::new();
/// let id = world.add(Point::new(vec2(0, 0)?, vec2(0, 0)?, 1)?)?;
/// let mut gravity = GravityY::new(dec!(-9.81))?;
/// for _ in 0..60 {
///     world.step(&mut Verlet, &mut gravity, &Step::hz(60)?);
/// }
/// assert!((world.get(id)?.velocity().y.to_f64() + 9.81).abs() < 1e-4); // after 1 s
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct GravityY<S: Scalar> {
    acceleration: S,
    gain: PerStep<S, S::Gain>,
    share: S,
}

impl<S: Scalar> GravityY<S> {
    /// `acceleration` in m/s², negative where y points up. Refuses a value outside the range.
    #[inline]
    pub fn new(acceleration: impl Into<Ratio>) -> Result<GravityY<S>, Error> {
        let (field, value) = ("acceleration", acceleration.into());
        let acceleration = S::ratio(value).ok_or(Error::OutOfRange { field, value })?;
        Ok(GravityY {
            acceleration,
            gain: PerStep::new(),
            share: S::ZERO,
        })
    }
}

impl<B: Body> Force<B> for GravityY<B::S> {
    const COUPLES: bool = false;

    #[inline]
    fn prepare<H: TimeStep<B::S>>(&mut self, now: &Now<H>) {
        let gain = self.gain.get(&now.step, |h| self.acceleration.gain(h));
        self.share = B::S::gained(gain, now.tick());
    }

    #[inline]
    fn field<H: TimeStep<B::S>>(&mut self, _now: &Now<H>, _seen: &B, live: &mut B) {
        live.kick_y(self.share);
    }

    fn potential(&self, _ids: &[BodyId], bodies: &[B]) -> f64 {
        super::potential(Vec2::new(B::S::ZERO, self.acceleration), bodies)
    }
}

impl<B: Body> Reversible<B> for Gravity<B::S> {}
impl<B: Body> Reversible<B> for GravityY<B::S> {}
