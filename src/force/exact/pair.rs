//! A spring between two bodies that nothing else holds, solved exactly by their reduced mass.
//!
//! ```text
//! d = x2 - x1 - rest,  w = v2 - v1,  s1 = m1 / (m1 + m2),  s2 = m2 / (m1 + m2),  μ = m1 s2
//! x1' = x1 + h (v1 + s2 w) - s2 ((p11 - 1) d + p12 w)
//! x2' = x2 + h (v2 - s1 w) + s1 ((p11 - 1) d + p12 w)
//! J   = μ (p21 d + (p22 - 1) w)          taken from body 1, added to body 2
//! ```
//!
//! The centre of mass moves by its velocity, and the difference as a spring with one fixed end does. One impulse is used
//! twice, so the two sum to zero to the bit. The rest position is a vector, not a length, which keeps the motion linear.
//! So a spring that rotates with its bodies is no such pair.

use super::propagator::{Propagator, Swing, length};
use crate::body::Body;
use crate::body::id::{self, BodyId};
use crate::error::Error;
use crate::force::{Force, Frame, Memo, Part, half};
use crate::ratio::Ratio;
use crate::scalar::{Decay, Factor, Scalar};
use crate::time::{Now, TimeStep};
use crate::vec2::Vec2;

/// Draws two bodies to `rest` from each other by frequency and damping, exact in position and
/// velocity at any step. Does nothing once a body is gone, where another flow has one, or where one is kinematic or static.
///
/// A force on one of the two alone is kicked in between; gravity, the same for both, disturbs nothing.
///
/// ```
/// use fixstep::{dec, vec2, ExactPair, Point, SemiImplicitEuler, Step, World};
/// let mut world = World::<_, 2>::new();
/// let a = world.add(Point::<f64>::new(vec2(0, 0)?, vec2(0, 0)?, 1)?)?;
/// let b = world.add(Point::<f64>::new(vec2(5, 0)?, vec2(0, 0)?, 3)?)?;
/// let mut spring = ExactPair::new([a, b], vec2(4, 0)?, dec!(0.5), 0)?; // 1 m too long
/// for _ in 0..60 {
///     world.step(&mut SemiImplicitEuler, &mut spring, &Step::hz(60)?);
/// }
/// // Half a period later it is 1 m too short: the light end has moved by 3/4 of 2 m.
/// assert!((world.get(a)?.position().x - 1.5).abs() < 1e-12);
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct ExactPair<S: Scalar> {
    bodies: [BodyId; 2],
    rest: Vec2<S>,
    swing: Swing,
    entries: Memo<(S::Coef, bool), [S::Coef; 4]>,
}

impl<S: Decay> ExactPair<S> {
    /// Ties `bodies` with a frequency of `hertz`, undamped, and a `damping_ratio` of which 1 is critical.
    /// `rest` (m) is the rest position of the second body relative to the first. Refuses a frequency that is not
    /// positive, below `2^-20` or from `2^20` on, and a damping ratio that is negative or from `2^10` on.
    pub fn new(
        bodies: [BodyId; 2],
        rest: Vec2<S>,
        hertz: impl Into<Ratio>,
        damping_ratio: impl Into<Ratio>,
    ) -> Result<ExactPair<S>, Error> {
        Ok(ExactPair {
            bodies,
            rest,
            swing: Swing::new(hertz.into(), damping_ratio.into())?,
            entries: Memo::new(),
        })
    }

    #[inline]
    fn entries(&mut self, step: &impl TimeStep<S>, whole: bool) -> [S::Coef; 4] {
        self.entries.get((step.coef(), whole), |(_, whole)| {
            Propagator::<S>::entries(self.swing, length(step.seconds(), whole))
        })
    }
}

impl<B: Body<S: Decay>> Force<B> for ExactPair<B::S> {
    const COUPLES: bool = false;
    const FLOWS: bool = true;

    #[inline]
    fn flow<H: TimeStep<B::S>>(
        &mut self,
        now: &Now<H>,
        part: Part,
        frame: &mut Frame<B>,
        moved: &mut [bool],
    ) {
        let [first, second] = self.bodies.map(|id| frame.find(id));
        let (Some((i, a)), Some((j, b))) = (first, second) else {
            return;
        };
        if a.has_infinite_mass() || b.has_infinite_mass() {
            return;
        }
        let Ok(marks) = moved.get_disjoint_mut([i, j]) else {
            return;
        };
        if marks.iter().any(|mark| **mark) {
            return;
        }
        marks.into_iter().for_each(|mark| *mark = true);
        let Some([first, second]) = frame.live_pair(i, j) else {
            return;
        };
        let whole = part == Part::Whole;
        let [p11, p12, p21, p22] = self.entries(&now.step, whole);
        let h = if whole {
            now.step.coef()
        } else {
            half::<B::S>(now.step.coef())
        };
        let product = <B::S as Scalar>::product;
        let [w1, w2] = [&a, &b].map(|body| body.inv_mass());
        let [m1, m2] = [w1, w2].map(<B::S as Scalar>::mass);
        let s1 = B::S::share(product(m1, w2.into()));
        let s2 = B::S::share(product(m2, w1.into()));
        let d = b.position() - a.position() - self.rest;
        let w = b.velocity() - a.velocity();
        for (body, [d, w], share) in [(&mut *first, [-d, w], s2), (&mut *second, [d, -w], s1)] {
            match part {
                Part::Whole => body.drift(&now.step),
                _ => body.drift_half(&now.step),
            }
            body.move_by(w, product(share, h));
            body.move_by(d, product(share, p11));
            body.move_by(-w, product(share, p12));
        }
        let reduced = product(m1, s2);
        let impulse = d.scaled(product(reduced, p21)) + w.scaled(product(reduced, p22));
        first.push(-impulse);
        second.push(impulse);
    }

    fn potential(&self, ids: &[BodyId], bodies: &[B]) -> f64 {
        let [first, second] = self
            .bodies
            .map(|id| id::position(ids, id).and_then(|i| bodies.get(i)));
        let (Some(a), Some(b)) = (first, second) else {
            return 0.0;
        };
        if a.has_infinite_mass() || b.has_infinite_mass() {
            return 0.0;
        }
        let [xa, xb] = [a, b].map(|body| body.position().to_f64());
        let z = xb - xa - self.rest.to_f64();
        let inverse = a.inv_mass().to_f64() + b.inv_mass().to_f64();
        self.swing.potential(z, inverse)
    }
}
