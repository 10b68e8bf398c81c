//! The classical Runge-Kutta method of order 4, for forces of any kind.
//!
//! With `k = h a(x, v, t)`, taken from four states one after another:
//!
//! ```text
//! 1   x               v              t           k1
//! 2   x + h/2 v       v + k1/2       t + h/2     k2
//! 3   x + h/2 v2      v + k2/2       t + h/2     k3
//! 4   x + h v3        v + k3         t + h       k4
//!
//! x' = x + h v + h/6 (k1 + k2 + k3)
//! v' = v + (k2 + k3) / 3 + (k1 + k4) / 6
//! ```
//!
//! The rule for x is `x + h/6 (v + 2 v2 + 2 v3 + v4)` with `v2 = v + k1/2`, `v3 = v + k2/2` and `v4 = v + k3`. Sums of k are
//! exact in fixed point, so x is rounded twice, v twice, and each k once. Two thirds and one third of the same k add up to
//! that k. So gravity keeps its fraction, and a body without forces moves as with semi-implicit Euler. One sum for v would
//! be six k long. These sums saturate where a step changes v by a third of the range.
//!
//! Order 4, for forces of x, v and t · four force calls, at the start, twice in the middle, at the end
//! · 48 bytes a body · stable for `h ω < 2.828`, below which a spring loses `(h ω)^6 / 144` of its
//! amplitude a step · stable for drag `k h / m < 2.785`, which stays monotone · exact drag makes it order 2 ·
//! not with contacts · not reversible
//! Source: Hairer, Nørsett, Wanner, "Solving Ordinary Differential Equations I" (1993), section II.1.

use super::{Method, copy, damp, parabola};
use crate::body::id::BodyId;
use crate::body::{Body, Spin};
use crate::force::{Force, Frame, Part, PerStep};
use crate::ratio::Ratio;
use crate::scalar::{Factor, Scalar};
use crate::time::{Between, Now, TimeStep};
use crate::vec2::Vec2;

/// Runge-Kutta of order 4 for worlds of `N` bodies: where a force depends on velocity or time, and
/// one step is to be exact. All forces act from the same instant.
///
/// It holds two copies of the bodies and a vector for each: 48 bytes for a [`Point`](crate::Point) of 32
/// bits, whether forces couple or not.
///
/// ```
/// use fixstep::{dec, vec2, LinearDrag, Point, Rk4, Step, World};
/// let mut world = World::<Point<f64>, 1>::new();
/// let ball = world.add(Point::new(vec2(0, 0)?, vec2(1, 0)?, 1)?)?;
/// let (mut rk4, mut drag, step) = (Rk4::new(), LinearDrag::new(1)?, Step::hz(10)?);
/// (0..10).for_each(|_| world.step(&mut rk4, &mut drag, &step));
/// let speed = world.get(ball)?.velocity().x;
/// assert!((speed - (-1.0_f64).exp()).abs() < 4e-7);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Rk4<B: Body, const N: usize> {
    seen: heapless::Vec<B, N>,
    live: heapless::Vec<B, N>,
    /// k1
    first: heapless::Vec<Change<B>, N>,
    /// 1/3, 1/6 and h/6.
    per_step: PerStep<B::S, [<B::S as Scalar>::Coef; 3]>,
}

/// What a k changes: velocity and spin.
type Change<B> = (Vec2<<B as Body>::S>, <B as Body>::Spin);

impl<B: Body, const N: usize> Rk4<B, N> {
    /// With room for the copies.
    #[must_use]
    pub const fn new() -> Self {
        Rk4 {
            seen: heapless::Vec::new(),
            live: heapless::Vec::new(),
            first: heapless::Vec::new(),
            per_step: PerStep::new(),
        }
    }

    /// The start of a step as seen by forces, and copies at rest for them to push.
    #[inline]
    fn begin(&mut self, bodies: &[B]) {
        copy(bodies, &mut self.seen);
        copy(bodies, &mut self.live);
        self.first.clear();
        for live in &mut self.live {
            live.halt();
            let _ = self.first.push((Vec2::ZERO, B::Spin::NONE));
        }
    }

    /// Adds `h a(seen)` to the velocities of `live`.
    #[inline]
    fn evaluate<F: Force<B>, H: TimeStep<B::S>>(
        &mut self,
        ids: &[BodyId],
        forces: &mut F,
        now: &Now<H>,
    ) {
        forces.couple(now, &mut Frame::split(ids, &self.seen, &mut self.live));
        for (seen, live) in self.seen.iter().zip(&mut self.live) {
            forces.field(now, seen, live);
        }
    }

    /// `f(body, seen, live, first)` for every body.
    #[inline(always)]
    fn each(
        &mut self,
        bodies: &mut [B],
        mut f: impl FnMut(&mut B, &mut B, &mut B, &mut Change<B>),
    ) {
        let copies = self
            .seen
            .iter_mut()
            .zip(&mut self.live)
            .zip(&mut self.first);
        for (body, ((seen, live), first)) in bodies.iter_mut().zip(copies) {
            f(body, seen, live, first);
        }
    }
}

impl<B: Body, const N: usize> Default for Rk4<B, N> {
    fn default() -> Self {
        Self::new()
    }
}

/// `1 / of`: inlined, or it would be divided at run time.
#[inline(always)]
fn part<S: Scalar>(of: u64) -> S::Coef {
    let part = Ratio::new(1, of).ok().and_then(Factor::new);
    part.unwrap_or(S::ZERO.coef())
}

/// The body `start` after moves by `dx` and a change of its velocity and spin.
fn state<B: Body>(start: &B, dx: Vec2<B::S>, (dv, spin): Change<B>) -> B {
    let mut body = *start;
    body.shift(dx);
    body.kick(dv);
    body.twist(spin);
    body
}

/// What a body that was at rest has gained.
#[inline(always)]
fn change<B: Body>(live: &B) -> Change<B> {
    (live.velocity(), live.spin())
}

/// Takes that from it.
#[inline(always)]
fn take<B: Body>(live: &mut B, (dv, spin): Change<B>) {
    live.kick(-dv);
    live.twist(spin.reversed());
}

impl<B: Body, const N: usize> Method<B, N> for Rk4<B, N> {
    #[inline]
    fn step<F: Force<B>, H: TimeStep<B::S>>(
        &mut self,
        ids: &[BodyId],
        bodies: &mut [B],
        forces: &mut F,
        step: &H,
        tick: u64,
    ) {
        const { assert!(!F::FLOWS, "a flow needs a splitting method") };
        let [third, sixth, h_sixth] = self.per_step.get(step, |h| {
            let (third, sixth) = (part::<B::S>(3), part::<B::S>(6));
            [third, sixth, B::S::product(sixth, h)]
        });
        let now = Now::start(step, tick);
        let h = now.step;
        let half = |(dv, spin): Change<B>| (dv.map(|k| k.dyadic(1, 1)), spin.half());
        forces.prepare(&now);
        damp(bodies, forces, &now, Part::FirstHalf);

        self.begin(bodies);
        self.evaluate(ids, forces, &now);
        self.each(bodies, |start, seen, live, k1| {
            *k1 = change(live);
            take(live, *k1);
            *seen = state(start, start.velocity().map(|v| h.half_times(v)), half(*k1));
            seen.rotate_by(start.spin().half(), h.coef());
        });

        let now = Now::middle(step, tick);
        forces.prepare(&now);
        self.evaluate(ids, forces, &now);
        self.each(bodies, |start, seen, live, _| {
            let spin = seen.spin();
            let dx = seen.velocity().map(|v| h.half_times(v));
            *seen = state(start, dx, half(change(live)));
            seen.rotate_by(spin.half(), h.coef());
        });

        // Now `live` holds k2 + k3, of which k2/2 = v3 - v gives k3 to a unit: enough for v4.
        forces.prepare(&now);
        self.evaluate(ids, forces, &now);
        self.each(bodies, |body, seen, live, k1| {
            let ((v3, spin), both) = (change(seen), change(live));
            let rise = v3 - body.velocity();
            let rise_of_spin = spin.sum(body.spin().reversed()).reversed();
            let k3 = (
                both.0 - rise - rise,
                both.1.sum(rise_of_spin).sum(rise_of_spin),
            );
            *seen = state(body, v3.map(|v| h.times(v)), k3);
            seen.rotate_by(spin, h.coef());
            take(live, both);
            body.drift(&h);
            body.move_by(k1.0 + both.0, h_sixth);
            body.rotate_by(k1.1.sum(both.1), h_sixth);
            body.kick_by(both.0, third);
            body.twist_part(both.1, third);
        });

        let now = Now::end(step, tick);
        forces.prepare(&now);
        self.evaluate(ids, forces, &now);
        self.each(bodies, |body, _, live, k1| {
            body.kick_by(k1.0 + live.velocity(), sixth);
            body.twist_part(k1.1.sum(live.spin()), sixth);
        });
        damp(bodies, forces, &now, Part::SecondHalf);
    }

    #[inline]
    fn between(&self, part: &Between<B::S>, before: &B, after: &B) -> Vec2<B::S> {
        parabola(part, before, after)
    }
}
