//! Uniform gravity: `dv = g h`, the same for every body.
//!
//! In fixed point `g h` seldom fits the type: at 60 Hz an `I16F16` would fall 1.3e-5 too slowly.
//! Its fraction is therefore spread over the ticks, so that the velocity gained in n steps is
//! `n g h` rounded once. That costs a few instructions a step and none a body.

use crate::body::Body;
use crate::force::{Force, PerStep};
use crate::id::BodyId;
use crate::scalar::{Factor, Scalar};
use crate::time::{Now, TimeStep};
use crate::vec2::Vec2;

/// The same acceleration for every body.
///
/// ```
/// use fixstep::{dec, vec2, Gravity};
/// let gravity = Gravity::new(vec2::<f32>(0, dec!(-9.81))?);
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gravity<S: Scalar> {
    acceleration: Vec2<S>,
    gain: PerStep<S, Vec2<S::Gain>>,
    share: Vec2<S>,
}

impl<S: Scalar> Gravity<S> {
    /// `acceleration` in m/s².
    pub fn new(acceleration: Vec2<S>) -> Gravity<S> {
        Gravity { acceleration, gain: PerStep::new(), share: Vec2::ZERO }
    }
}

impl<B: Body> Force<B> for Gravity<B::S> {
    #[inline]
    fn prepare<H: TimeStep<B::S>>(&mut self, now: &Now<H>) {
        let gain = self.gain.get(now.step, |h| self.acceleration.map(|g| g.gain(h)));
        self.share = Vec2 { x: B::S::gained(gain.x, now.tick()), y: B::S::gained(gain.y, now.tick()) };
    }

    #[inline]
    fn field<H: TimeStep<B::S>>(&mut self, _now: &Now<H>, _seen: &B, live: &mut B) {
        live.kick(self.share);
    }

    fn potential(&self, _ids: &[BodyId], bodies: &[B]) -> f64 {
        let g = self.acceleration.to_f64();
        let of = |body: &B| {
            let x = body.position().to_f64();
            -(g.x * x.x + g.y * x.y) / body.inv_mass().to_f64()
        };
        bodies.iter().map(of).sum()
    }
}
