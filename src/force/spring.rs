//! A spring with damper between two bodies.
//!
//! ```text
//! d = x2 - x1,  L = |d|
//! j = k h (L - L0) + c h (v2 - v1)·d / L      impulse along d
//! J = j d / L                                 added to body 1, taken from body 2
//! ```
//!
//! One impulse is used twice, so the two sum to zero to the bit. Where the bodies coincide there is no direction, and the
//! spring does nothing.

use crate::body::Body;
use crate::error::Error;
use crate::force::{PairForce, PerStep, ReversiblePair, coefficient, is_none};
use crate::ratio::Ratio;
use crate::scalar::{Factor, Scalar};
use crate::time::{Now, TimeStep};
use crate::vec2::Vec2;

/// Draws two bodies to a distance and damps their motion along the line between them.
///
/// With `SemiImplicitEuler` and `Verlet` a damper sees what the pairs before it have just pushed. In a hanging chain each
/// spring is shorter by `c h / m` of the stretch of the spring before it. Damp a chain with drag.
///
/// [`Pairs`](crate::Pairs) chooses the two bodies.
///
/// ```
/// use fixstep::prelude::*;
/// let mut world = World::<Point<f32>, 2>::new();
/// let a = world.add(Point::new(vec2(0, 0)?, vec2(0, 0)?, 1)?)?;
/// let b = world.add(Point::new(vec2(3, 0)?, vec2(0, 0)?, 2)?)?;
/// let mut spring = Pairs::new(Spring::new(2, 40, dec!(0.5))?, [[a, b]]);
/// world.step(&mut SemiImplicitEuler, &mut spring, &Step::hz(8)?);
/// assert_eq!(world.get(a)?.velocity(), vec2(5, 0)?); // 40 N/m at 1 m, for 1/8 s
/// assert_eq!(world.get(b)?.velocity(), vec2(dec!(-2.5), 0)?); // twice the mass
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Spring<S: Scalar> {
    rest_length: S,
    stiffness: S::Coef,
    damping: S::Coef,
    per_step: PerStep<S, (S::Coef, S::Coef)>,
}

impl<S: Scalar> Spring<S> {
    /// `rest_length` in m, `stiffness` in N/m and `damping` in kg/s, none negative. Refuses values
    /// that the scalar or its coefficients cannot hold.
    #[inline]
    pub fn new(
        rest_length: impl Into<Ratio>,
        stiffness: impl Into<Ratio>,
        damping: impl Into<Ratio>,
    ) -> Result<Spring<S>, Error> {
        let (field, value) = ("rest_length", rest_length.into());
        if value.num() < 0 {
            return Err(Error::Negative { field, value });
        }
        let rest_length = S::ratio(value).ok_or(Error::OutOfRange { field, value })?;
        let stiffness = coefficient::<S>("stiffness", stiffness.into())?;
        let damping = coefficient::<S>("damping", damping.into())?;
        Ok(Spring {
            rest_length,
            stiffness,
            damping,
            per_step: PerStep::new(),
        })
    }

    /// The impulse on the first end over one step: from where the second is as seen from it, and how it
    /// moves.
    #[inline]
    pub(crate) fn impulse<H: TimeStep<S>>(
        &mut self,
        step: &H,
        along: impl FnOnce() -> Vec2<S>,
        apart: impl FnOnce() -> Vec2<S>,
    ) -> Vec2<S> {
        let (stiffness, damping) = self.per_step.get(step, |h| {
            (S::product(self.stiffness, h), S::product(self.damping, h))
        });
        let along = along();
        let length = along.length();
        let closing = S::quotient(apart().dot(along), length);
        let pull = stiffness.scale(length.minus(self.rest_length));
        along.with_length(pull.plus(damping.scale(closing)), length)
    }

    /// The name of the force, if it damps.
    pub(crate) fn damper_name(&self) -> Option<&'static str> {
        (!is_none::<S>(self.damping)).then_some("Spring")
    }

    /// Potential energy at that distance, J.
    pub(crate) fn potential_along(&self, along: Vec2<f64>) -> f64 {
        let stretch = along.length() - self.rest_length.to_f64();
        0.5 * self.stiffness.to_f64() * stretch * stretch
    }
}

impl<B: Body> PairForce<B> for Spring<B::S> {
    #[inline]
    fn act<H: TimeStep<B::S>>(&mut self, now: &Now<H>, seen: [&B; 2], live: [&mut B; 2]) {
        let [a, b] = seen;
        let impulse = self.impulse(
            &now.step,
            || b.position() - a.position(),
            || b.velocity() - a.velocity(),
        );
        let [first, second] = live;
        first.push(impulse);
        second.push(-impulse);
    }

    fn potential(&self, bodies: [&B; 2]) -> f64 {
        let [a, b] = bodies.map(|body| body.position().to_f64());
        self.potential_along(b - a)
    }
}

impl<B: Body> ReversiblePair<B> for Spring<B::S> {
    fn damper(&self, _tick: u64) -> Option<&'static str> {
        self.damper_name()
    }
}
