//! Gravity and linear drag together, solved exactly: the flight of a ball in syrup.
//!
//! ```text
//! v' = v - loss v + φ1 h g          x = k h / m
//! x' = x + φ1 h v + φ2 h² g         loss, φ1, φ2 of x as in `Decay::decay`
//! ```
//!
//! A flow: it replaces the drift of every body that no other flow has. What other forces do is kicked
//! beside it. Source: the exact solution of `m v' = m g - k v`; the weights are those of Cox, Matthews,
//! "Exponential time differencing for stiff systems", J. Comput. Phys. 176 (2002).

use crate::body::Body;
use crate::body::id::BodyId;
use crate::error::Error;
use crate::force::{Force, Frame, Memo, Part, PerStep, coefficient, half};
use crate::ratio::Ratio;
use crate::scalar::{Decay, Scalar};
use crate::time::{Now, TimeStep};
use crate::vec2::Vec2;

/// The same acceleration for every body, against linear drag; exact in position and velocity at any
/// step. Instead of [`Gravity`](crate::Gravity) and [`ExactDrag`](crate::ExactDrag), not beside them.
///
/// Put it after exact springs in the tuple: it moves every body that no flow before it has moved. Do not use
/// [`with_gravity`](crate::ExactSpring::with_gravity) for a spring beside it, since no `Gravity` kicks its body.
/// As with `ExactDrag`, add bodies of equal mass one after another.
///
/// ```
/// use fixstep::{dec, vec2, Ballistic, Point, SemiImplicitEuler, Step, World};
/// let mut world = World::<_, 1>::new();
/// let id = world.add(Point::<f64>::new(vec2(0, 0)?, vec2(0, 0)?, 1)?)?;
/// let mut flight = Ballistic::new(vec2(0, -10)?, 2)?; // terminal speed 5 m/s
/// for _ in 0..20 {
///     world.step(&mut SemiImplicitEuler, &mut flight, &Step::hz(20)?);
/// }
/// let exact = -5.0 * (1.0 - (-2.0_f64).exp());
/// assert!((world.get(id)?.velocity().y - exact).abs() < 1e-14);
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Ballistic<S: Scalar> {
    acceleration: Vec2<S>,
    drag: S::Coef,
    per_step: PerStep<S, [S::Coef; 2]>,
    flight: Memo<(S::InvMass, bool), Flight<S>>,
}

/// What a body of one mass does in a step or in half of it.
#[derive(Clone, Copy, Debug)]
struct Flight<S: Scalar> {
    loss: S::Coef,
    time: S::Coef,
    kick: [S::Gain; 2],
    fall: [S::Gain; 2],
}

impl<S: Decay> Ballistic<S> {
    /// `acceleration` in m/s² and `drag` in kg/s, not negative. Refuses a drag that the scalar's
    /// coefficients cannot hold.
    #[inline]
    pub fn new(acceleration: Vec2<S>, drag: impl Into<Ratio>) -> Result<Ballistic<S>, Error> {
        Ok(Ballistic {
            acceleration,
            drag: coefficient::<S>("drag", drag.into())?,
            per_step: PerStep::new(),
            flight: Memo::new(),
        })
    }
}

impl<S: Decay> Flight<S> {
    fn new(g: Vec2<S>, [h, rate]: [S::Coef; 2], inv_mass: S::InvMass, whole: bool) -> Flight<S> {
        let part = |c| if whole { c } else { half::<S>(c) };
        let h = part(h);
        let [loss, mean, mean_loss] = S::decay(S::product(part(rate), inv_mass.into()));
        let time = S::product(mean, h);
        let square = S::product(S::product(mean_loss, h), h);
        Flight {
            loss,
            time,
            kick: g.array().map(|g| g.gain(time)),
            fall: g.array().map(|g| g.gain(square)),
        }
    }
}

impl<B: Body<S: Decay>> Force<B> for Ballistic<B::S> {
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
        let mut renewed = false;
        let rates = self.per_step.get(&now.step, |h| {
            renewed = true;
            [h, B::S::product(self.drag, h)]
        });
        if renewed {
            self.flight.forget();
        }
        let whole = part == Part::Whole;
        // Halves have a count of their own, so that the shares of both alternate.
        let tick = match part {
            Part::Whole => now.tick(),
            Part::FirstHalf => now.tick().wrapping_mul(2),
            Part::SecondHalf => now.tick().wrapping_mul(2).wrapping_add(1),
        };
        let share = |[x, y]: [<B::S as Scalar>::Gain; 2]| {
            Vec2::new(B::S::gained(x, tick), B::S::gained(y, tick))
        };
        let free = frame
            .live()
            .iter_mut()
            .zip(moved)
            .filter(|(body, moved)| !(**moved || body.has_infinite_mass()));
        for (body, moved) in free {
            let inv_mass = body.inv_mass();
            let flight = self.flight.get((inv_mass, whole), |(inv_mass, whole)| {
                Flight::new(self.acceleration, rates, inv_mass, whole)
            });
            body.drift_by(flight.time);
            match part {
                Part::Whole => body.drift_angle(&now.step),
                _ => body.drift_angle_half(&now.step),
            }
            body.shift(share(flight.fall));
            body.damp(flight.loss);
            body.kick(share(flight.kick));
            *moved = true;
        }
    }

    fn potential(&self, _ids: &[BodyId], bodies: &[B]) -> f64 {
        crate::force::potential(self.acceleration, bodies)
    }
}
