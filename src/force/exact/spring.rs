//! A spring to a fixed point, solved exactly: in position and in velocity, at any step and damping.
//!
//! It is a *flow*: it replaces the drift of its body. Other forces kick between two flows, and the motion that they start
//! is exact again. The rest length is zero, so the axes do not mix.
//!
//! A constant acceleration moves the rest position by `g / ω²`. A spring made [`with_gravity`](ExactSpring::with_gravity)
//! takes back the kick that [`Gravity`](crate::Gravity) gave its body, and swings about the point where it hangs.

use super::oscillation;
use super::propagator::{Propagator, Swing, length};
use crate::body::Body;
use crate::body::id::{self, BodyId};
use crate::error::Error;
use crate::force::{Force, Frame, Memo, Part};
use crate::ratio::Ratio;
use crate::scalar::{Factor, Scalar};
use crate::time::{Now, TimeStep};
use crate::vec2::Vec2;

/// Ties one body to a point by frequency and damping, exact for `h ω` of 0.1 or 6. Does nothing once
/// the body is gone, or where another flow has it.
///
/// Its coefficients are computed in the first step, and again when the length of the step changes. That takes
/// some dozens of products of 128 bits, which is slow on a small core.
///
/// ```
/// use fixstep::{dec, vec2, ExactSpring, Point, SemiImplicitEuler, Step, World};
/// let mut world = World::<_, 1>::new();
/// let id = world.add(Point::<f64>::new(vec2(1, 0)?, vec2(0, 0)?, 1)?)?;
/// // 25.25 periods in each second of 60 steps: Euler's methods explode from 19.
/// let mut spring = ExactSpring::new(id, vec2(0, 0)?, dec!(25.25), 0)?;
/// for _ in 0..120 {
///     world.step(&mut SemiImplicitEuler, &mut spring, &Step::hz(60)?);
/// }
/// assert!((world.get(id)?.position().x + 1.0).abs() < 1e-12);
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct ExactSpring<S: Scalar> {
    body: BodyId,
    point: Vec2<S>,
    swing: Swing,
    load: Option<Load<S>>,
    motion: Memo<(S::Coef, bool), Motion<S>>,
}

/// A constant acceleration, and how far the spring sags by it.
#[derive(Clone, Copy, Debug)]
struct Load<S> {
    acceleration: Vec2<S>,
    sag: Vec2<S>,
}

/// What the spring does in a step or in half of it.
#[derive(Clone, Copy, Debug)]
struct Motion<S: Scalar> {
    propagator: Propagator<S>,
    kick: Option<[S::Gain; 2]>,
}

impl<S: Scalar> ExactSpring<S> {
    /// Ties `body` to `point` (m) with a frequency of `hertz`, undamped, and a `damping_ratio` of which 1
    /// is critical. Refuses a frequency that is not positive, below `2^-20` or from `2^20` on, and a
    /// damping ratio that is negative or from `2^10` on.
    pub fn new(
        body: BodyId,
        point: Vec2<S>,
        hertz: impl Into<Ratio>,
        damping_ratio: impl Into<Ratio>,
    ) -> Result<ExactSpring<S>, Error> {
        Ok(ExactSpring {
            body,
            point,
            swing: Swing::new(hertz.into(), damping_ratio.into())?,
            load: None,
            motion: Memo::new(),
        })
    }

    /// Moves the rest position to where the spring balances `acceleration`, m/s². Use the acceleration of the
    /// scene's [`Gravity`](crate::Gravity), which must act on the body too. Refuses a sag out of range.
    ///
    /// A drag beside it takes a part of gravity's kick, but the spring takes back the whole kick. With an
    /// [`ExactDrag`](crate::ExactDrag) of `x = k h / m` the body hangs x of its sag higher, with
    /// [`Verlet`](crate::Verlet) half of that. Give the spring its damping instead. A [`Point`](crate::Point) comes
    /// to rest within its dead zone of the rest position, a [`Carried`](crate::Carried) body within a unit, in
    /// floats two.
    pub fn with_gravity(self, acceleration: Vec2<S>) -> Result<ExactSpring<S>, Error> {
        let (field, value) = ("hertz", self.swing.hertz);
        let error = Error::OutOfRange { field, value };
        let sag = oscillation::sag(value).ok_or(error)?;
        // One too small for a coefficient is no sag, one too large is out of range.
        if sag.exponent_above() > S::COEF_BITS as i32 {
            return Err(error);
        }
        let sag = acceleration.scaled(S::Coef::new(sag).unwrap_or(S::ZERO.coef()));
        // A product that has saturated may come back into the range by the sum.
        if !(sag.is_inside() && (self.point + sag).is_inside()) {
            return Err(error);
        }
        let load = Some(Load { acceleration, sag });
        Ok(ExactSpring {
            load,
            motion: Memo::new(), // what it has was made for another load, or none
            ..self
        })
    }

    /// Its rest position, m.
    #[must_use]
    pub fn rest_position(&self) -> Vec2<S> {
        self.load.map_or(self.point, |load| self.point + load.sag)
    }

    #[inline]
    fn motion(&mut self, step: &impl TimeStep<S>, whole: bool) -> Motion<S> {
        self.motion.get((step.coef(), whole), |(h, whole)| {
            let gains = |load: Load<S>| load.acceleration.array().map(|g| g.gain(h));
            Motion {
                propagator: Propagator::new(self.swing, length(step.seconds(), whole)),
                kick: self.load.map(gains),
            }
        })
    }
}

impl<B: Body> Force<B> for ExactSpring<B::S> {
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
        let Some((index, _)) = frame.find(self.body) else {
            return;
        };
        match (moved.get_mut(index), frame.live_at(index)) {
            (Some(moved), Some(live)) if !(*moved || live.has_infinite_mass()) => {
                *moved = true;
                let motion = self.motion(&now.step, part == Part::Whole);
                if let (Some([x, y]), true) = (motion.kick, part != Part::FirstHalf) {
                    let gained = |gain| B::S::gained(gain, now.tick());
                    live.kick(-Vec2::new(gained(x), gained(y)));
                }
                motion.propagator.apply(self.rest_position(), live);
                match part {
                    Part::Whole => live.drift_angle(&now.step),
                    _ => live.drift_angle_half(&now.step),
                }
            }
            _ => {}
        }
    }

    fn potential(&self, ids: &[BodyId], bodies: &[B]) -> f64 {
        let body = id::position(ids, self.body).and_then(|i| bodies.get(i));
        body.map_or(0.0, |body| {
            let z = body.position().to_f64() - self.point.to_f64();
            self.swing.potential(z, body.inv_mass().to_f64())
        })
    }
}
