//! A constant torque on one body: a motor.
//!
//! In fixed point `M h / 2πI` seldom fits the type. As with gravity its fraction is spread over the ticks.
//! So the spin gained in n steps is `n h M / 2πI` rounded once.

use crate::body::id::BodyId;
use crate::force::{Force, Frame, Reversible};
use crate::rigid::Rotating;
use crate::scalar::Scalar;
use crate::time::{Now, TimeStep};

/// Rotates one body with the same torque in every step. Does nothing once the body is gone.
///
/// ```
/// use fixstep::{prelude::*, rigid::torque::Torque};
/// let mut world = World::<_, 1>::new();
/// let wheel = world.add(Rigid::new(Point::<f32>::new(vec2(0, 0)?, vec2(0, 0)?, 2)?, dec!(0.1))?)?;
/// let mut motor = Torque { body: wheel, torque: 0.5 };
/// for _ in 0..64 {
///     world.step(&mut SemiImplicitEuler, &mut motor, &Step::hz(64)?);
/// }
/// let exact = 5.0 / core::f32::consts::TAU; // M t / I = 5 rad/s
/// assert!((world.get(wheel)?.spin() - exact).abs() < 1e-4);
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Torque<S> {
    /// The body that is rotated.
    pub body: BodyId,
    /// The torque, N m.
    pub torque: S,
}

impl<B: Rotating> Force<B> for Torque<B::S> {
    const COUPLES: bool = true;

    #[inline]
    fn couple<H: TimeStep<B::S>>(&mut self, now: &Now<H>, frame: &mut Frame<B>) {
        let Some((index, body)) = frame.find(self.body) else {
            return;
        };
        let per_inertia = B::S::product(now.step.coef(), body.inv_inertia());
        let gain = B::S::gained(self.torque.gain(per_inertia), now.tick());
        if let Some(live) = frame.live_at(index) {
            live.spin_up(gain);
        }
    }
}

impl<B: Rotating> Reversible<B> for Torque<B::S> {}
