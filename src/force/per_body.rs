//! Any function of time and of a body's own state.

use crate::body::Body;
use crate::force::Force;
use crate::scalar::Scalar;
use crate::time::{Now, Time, TimeStep};
use crate::vec2::Vec2;

/// A force, in newtons, that `F` computes from the time and the body alone. For bodies that rotate it can be a
/// force and a torque: any [`Effort`].
///
/// ```
/// use fixstep::{Time, prelude::*};
/// // Wind that blows above the ground only.
/// let mut wind = PerBody(|_: Time, body: &Point<f32>| {
///     let blows = body.position().y > 0.0;
///     Vec2::new(if blows { 2.0 } else { 0.0 }, 0.0)
/// });
/// let mut world = World::<_, 1>::new();
/// let kite = world.add(Point::new(vec2(0, 9)?, vec2(0, 0)?, 4)?)?;
/// world.step(&mut SemiImplicitEuler, &mut wind, &Step::hz(8)?);
/// assert_eq!(world.get(kite)?.velocity().x, 0.0625); // 2 N, 4 kg, 1/8 s
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct PerBody<F>(
    /// The function.
    pub F,
);

/// What a function of [`PerBody`] returns: a force, or for a body that rotates a
/// [`Wrench`](crate::rigid::torque::Wrench).
///
/// ```
/// use fixstep::{force::Effort, prelude::*, rigid::torque::Wrench};
/// let seen = Rigid::new(Point::<f32>::new(vec2(0, 0)?, vec2(0, 0)?, 4)?, 1)?;
/// let mut live = seen;
/// Vec2::new(2.0, 0.0).act(0.5, &seen, &mut live); // a force of 2 N for half a second
/// assert_eq!(live.velocity(), vec2(dec!(0.25), 0)?);
/// Wrench { force: Vec2::ZERO, torque: 2.0 }.act(0.5, &seen, &mut live);
/// assert!((live.spin() - 1.0 / core::f32::consts::TAU).abs() < 1e-6); // 1 rad/s
/// # Ok::<(), fixstep::Error>(())
/// ```
pub trait Effort<B: Body> {
    /// Changes the velocity of `live` by what acts on `seen` for a time `h`.
    fn act(self, h: <B::S as Scalar>::Coef, seen: &B, live: &mut B);
}

/// A force, N.
impl<B: Body> Effort<B> for Vec2<B::S> {
    #[inline]
    fn act(self, h: <B::S as Scalar>::Coef, seen: &B, live: &mut B) {
        live.kick_by(self, B::S::product(h, seen.inv_mass().into()));
    }
}

impl<B: Body, E: Effort<B>, F: FnMut(Time, &B) -> E> Force<B> for PerBody<F> {
    const COUPLES: bool = false;

    #[inline]
    fn field<H: TimeStep<B::S>>(&mut self, now: &Now<H>, seen: &B, live: &mut B) {
        let effort = (self.0)(now.time(), seen);
        effort.act(now.step.coef(), seen, live);
    }
}
