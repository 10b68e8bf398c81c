//! A pair force whose ends are not the centres of mass.
//!
//! ```text
//! p = x + R(θ) a,  u = v + ω × (p - x)        where an end is and how it moves
//! J from the spring between p1 and p2         one impulse, used twice
//! s1 += (p1 - x1)×J / 2πI1,  s2 -= (p2 - x2)×J / 2πI2
//! ```
//!
//! The impulse is along `p2 - p1` but for its rounding. So both torques cancel about any point, and angular momentum
//! changes by rounding alone.

use crate::force::{PairForce, ReversiblePair, Spring};
use crate::rigid::Rotating;
use crate::scalar::Scalar;
use crate::time::{Now, TimeStep};
use crate::vec2::Vec2;

/// A [`Spring`] between a point of one body and a point of another.
///
/// ```
/// use fixstep::{prelude::*, rigid::torque::Attached};
/// let mut world = World::<_, 2>::new();
/// let rod = Point::<f32>::new(vec2(0, 0)?, vec2(0, 0)?, 1)?;
/// let rod = world.add(Rigid::new(rod, dec!(0.5))?)?;
/// let wall = world.add(Rigid::<Point<f32>>::static_at(vec2(4, 0)?)?)?;
/// // From the end of the rod to the middle of the wall.
/// let spring = Attached { spring: Spring::new(2, 40, dec!(0.5))?, at: [vec2(1, 0)?, Vec2::ZERO] };
/// let mut spring = Pairs::new(spring, [[rod, wall]]);
/// world.step(&mut SemiImplicitEuler, &mut spring, &Step::hz(8)?);
/// assert_eq!(world.get(rod)?.velocity(), vec2(5, 0)?); // 3 m long: 40 N for 1/8 s
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Attached<S: Scalar> {
    /// What acts.
    pub spring: Spring<S>,
    /// Where, in the axes of the first body and of the second, m.
    pub at: [Vec2<S>; 2],
}

impl<B: Rotating> PairForce<B> for Attached<B::S> {
    #[inline]
    fn act<H: TimeStep<B::S>>(&mut self, now: &Now<H>, seen: [&B; 2], live: [&mut B; 2]) {
        let [a, b] = seen;
        let arms = [
            a.rotation().rotate(self.at[0]),
            b.rotation().rotate(self.at[1]),
        ];
        let impulse = self.spring.impulse(
            &now.step,
            || (b.position() - a.position()) + (arms[1] - arms[0]),
            || b.velocity_off(arms[1]) - a.velocity_off(arms[0]),
        );
        let [first, second] = live;
        first.push_off(arms[0], impulse);
        second.push_off(arms[1], -impulse);
    }

    fn potential(&self, bodies: [&B; 2]) -> f64 {
        let [a, b] = bodies;
        let along = b.to_world(self.at[1]).to_f64() - a.to_world(self.at[0]).to_f64();
        self.spring.potential_along(along)
    }
}

impl<B: Rotating> ReversiblePair<B> for Attached<B::S> {
    fn damper(&self, _tick: u64) -> Option<&'static str> {
        self.spring.damper_name()
    }
}
