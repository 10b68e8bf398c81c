//! A force together with a torque.

use crate::force::Effort;
use crate::rigid::Rotating;
use crate::scalar::Scalar;
use crate::vec2::Vec2;

/// What a function for [`PerBody`](crate::PerBody) returns to move and rotate a body.
///
/// ```
/// use fixstep::{Time, prelude::*, rigid::torque::Wrench};
/// // A torsion spring that holds angle zero with 3 N m a turn.
/// let mut spring = PerBody(|_: Time, body: &Rigid<Point<f32>>| Wrench {
///     force: Vec2::ZERO,
///     torque: -3.0 * body.angle().to_f64() as f32,
/// });
/// let door = Rigid::new(Point::new(vec2(0, 0)?, vec2(0, 0)?, 1)?, 1)?.with_angle(Angle::degrees(120));
/// let mut world = World::<_, 1>::new();
/// let id = world.add(door)?;
/// world.step(&mut SemiImplicitEuler, &mut spring, &Step::hz(8)?);
/// let exact = -0.125 / core::f32::consts::TAU; // -1 N m for 1/8 s, 1 kg m²
/// assert!((world.get(id)?.spin() - exact).abs() < 1e-6);
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wrench<S> {
    /// At the centre of mass, N.
    pub force: Vec2<S>,
    /// About it, N m.
    pub torque: S,
}

impl<S: Scalar> Wrench<S> {
    /// A force (N) at the end of an arm (m): rounds the torque to the scalar.
    #[inline]
    #[must_use]
    pub fn at(arm: Vec2<S>, force: Vec2<S>) -> Wrench<S> {
        let torque = S::narrow(arm.cross(force));
        Wrench { force, torque }
    }
}

impl<B: Rotating> Effort<B> for Wrench<B::S> {
    #[inline]
    fn act(self, h: <B::S as Scalar>::Coef, seen: &B, live: &mut B) {
        self.force.act(h, seen, live);
        live.twist_by(self.torque, B::S::product(h, seen.inv_inertia()));
    }
}
