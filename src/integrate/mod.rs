//! Methods, and the stages they are made of.
//!
//! | method | order | force calls | bytes a body | spring, `h ω <` | drag, `k h / m <` | contacts | reversible | M0+ | M4F | worst known failure |
//! |---|---|---|---|---|---|---|---|---|---|---|
//! | [`Euler`] | 1 | 1 | 20 | 0 | 2 | yes | no | 63 | 15 | a spring grows by `(h ω)²/2` a step |
//! | [`ConstantAcceleration`] | 1; exact for constant force | 1 | 20 | 0 | 2 | no | no | 94 | 19 | a spring grows by `(h ω)²/4` a step |
//! | [`SemiImplicitEuler`] | 1 | 1 | 0 | 2 | 2 | yes | yes | 65 | 15 | a fall is `g T h / 2` long |
//! | [`Verlet`] | 2; exact for constant force | 1 | 0 | 2 | 2 | no | yes | 94 | 19 | a spring runs ahead by `(h ω)²/24` of its phase |
//! | [`Rk4`] | 4 | 4 | 48 | 2.828 | 2.785 | no | no | 948 | 338 | a spring loses `(h ω)^6/144` a step, for ever |
//! | [`Pefrl`] | 4 for forces of position | 4 | 0 | 2.989 | 2.341 | no | yes | 631 | 130 | order 1 with explicit drag |
//!
//! Bytes are those of a [`Point`](crate::Point) of 32 bits, held by the method. The limit for a spring is
//! that of an undamped one, the limit for drag that of [`LinearDrag`](crate::LinearDrag); the exact ones
//! have none. Contacts: see [`ContactGap`]. Reversible: in fixed point, with forces of position,
//! [`World::step_back`](crate::World::step_back) restores every bit. M0+ and M4F: instructions per body and
//! step of 32 points in `I16F16` with gravity at 1/60 s. [`guide`](crate::guide) says which to take.
//!
//! [`kick`], [`damp`], [`drift`] and [`drift_half`] are free functions over slices: a scene that wants
//! another order calls them itself, with one [`Now`] for all stages of a step. A method that fuses
//! two of them gives the same bits.

mod constant_acceleration;
mod euler;
mod pefrl;
mod rewinds;
mod rk4;
mod seen;
mod semi_implicit;
mod verlet;

use crate::body::Body;
use crate::body::id::BodyId;
use crate::force::{Force, Frame, Part};
use crate::time::{Between, Now, TimeStep};
use crate::vec2::Vec2;

pub use constant_acceleration::ConstantAcceleration;
pub use euler::Euler;
pub use pefrl::Pefrl;
pub use rewinds::Rewinds;
pub use rk4::Rk4;
pub use semi_implicit::SemiImplicitEuler;
pub use verlet::Verlet;

/// A way to make one step, for worlds of `N` bodies.
///
/// ```
/// use fixstep::{Method, Rk4, prelude::*};
/// fn fall<M: Method<Point<f64>, 1>>(mut method: M) -> Result<f64, Error> {
///     let mut world = World::<Point<f64>, 1>::new();
///     let ball = world.add(Point::new(vec2(0, 0)?, vec2(0, 0)?, 1)?)?;
///     let (mut gravity, step) = (GravityY::new(-8)?, Step::hz(64)?);
///     (0..64).for_each(|_| world.step(&mut method, &mut gravity, &step));
///     Ok(world.get(ball)?.position().y)
/// }
/// assert!(fall(Verlet)? == -4.0 && (fall(Rk4::new())? + 4.0).abs() < 1e-12); // in a second
/// # Ok::<(), fixstep::Error>(())
/// ```
pub trait Method<B: Body, const N: usize> {
    /// Moves `bodies`, whose ids are `ids`, from tick `tick` to the next.
    fn step<F: Force<B>, H: TimeStep<B::S>>(
        &mut self,
        ids: &[BodyId],
        bodies: &mut [B],
        forces: &mut F,
        step: &H,
        tick: u64,
    );

    /// Where a body was at a part of the step from `before` to `after`: on the straight line, for a
    /// method whose bodies keep one velocity through a step. A method that wraps another hands this on.
    #[inline]
    #[must_use]
    fn between(&self, part: &Between<B::S>, before: &B, after: &B) -> Vec2<B::S> {
        part.chord(before.position(), after.position())
    }
}

/// A method that allows contacts to change velocities after its kicks. No body moves by a velocity that contacts
/// have not seen.
///
/// [`SemiImplicitEuler`] has that gap between its kick and its drift, [`Euler`] at the end of its step:
/// its next drift takes the velocity as it then is. The others move bodies on both sides of a kick,
/// and a contact would correct only some of that.
///
/// ```
/// use fixstep::integrate::ContactGap;
/// use fixstep::{Point, Rk4, SemiImplicitEuler};
/// fn with_contacts(_: impl ContactGap<Point<f32>, 8>) {}
/// with_contacts(SemiImplicitEuler);
/// ```
///
/// ```compile_fail,E0277
/// use fixstep::integrate::ContactGap;
/// use fixstep::{Point, Rk4, SemiImplicitEuler};
/// fn with_contacts(_: impl ContactGap<Point<f32>, 8>) {}
/// with_contacts(Rk4::new());
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be combined with contacts",
    note = "it has no gap between its kicks and its drifts; `SemiImplicitEuler` has one"
)]
pub trait ContactGap<B: Body, const N: usize>: Method<B, N> {}

impl<B: Body, const N: usize> ContactGap<B, N> for Euler<B, N> {}
impl<B: Body, const N: usize> ContactGap<B, N> for SemiImplicitEuler {}

/// A parabola: the path of a method with a constant acceleration in each step. A smooth motion
/// leaves it by up to `0.008 h³` times its third derivative: drawn with an error of order 3.
#[inline]
fn parabola<B: Body>(part: &Between<B::S>, before: &B, after: &B) -> Vec2<B::S> {
    let change = after.velocity() - before.velocity();
    part.chord(before.position(), after.position()) + part.bow(change)
}

/// Stage: every force changes velocities; positions stay.
///
/// ```
/// use fixstep::{Now, integrate::kick, prelude::*};
/// let mut world = World::<Point<f32>, 1>::new();
/// world.add(Point::new(vec2(0, 0)?, vec2(0, 0)?, 1)?)?;
/// let (ids, mut bodies) = (world.ids(), [world.bodies()[0]]);
/// kick(ids, &mut bodies, &mut GravityY::new(-8)?, &Now::start(&Step::hz(64)?, 0));
/// assert_eq!(bodies[0].velocity().y, -0.125); // g h
/// # Ok::<(), fixstep::Error>(())
/// ```
#[inline]
pub fn kick<B: Body, F: Force<B>, H: TimeStep<B::S>>(
    ids: &[BodyId],
    bodies: &mut [B],
    forces: &mut F,
    now: &Now<H>,
) {
    forces.prepare(now);
    forces.couple(now, &mut Frame::new(ids, bodies));
    each(bodies, |body| {
        let seen = *body;
        forces.field(now, &seen, body);
    });
}

/// Stage: `x += h v` for every body.
///
/// ```
/// use fixstep::{Now, integrate::drift, prelude::*};
/// let mut bodies = [Point::<f32>::new(vec2(0, 0)?, vec2(32, 0)?, 1)?];
/// drift(&mut bodies, &Now::start(&Step::hz(64)?, 0));
/// assert_eq!(bodies[0].position(), vec2(dec!(0.5), 0)?);
/// # Ok::<(), fixstep::Error>(())
/// ```
#[inline]
pub fn drift<B: Body, H: TimeStep<B::S>>(bodies: &mut [B], now: &Now<H>) {
    each(bodies, |body| body.drift(&now.step));
}

/// Stage: `x += h/2 v` for every body.
///
/// ```
/// use fixstep::{Now, integrate::drift_half, prelude::*};
/// let mut bodies = [Point::<f32>::new(vec2(0, 0)?, vec2(32, 0)?, 1)?];
/// drift_half(&mut bodies, &Now::start(&Step::hz(64)?, 0));
/// assert_eq!(bodies[0].position(), vec2(dec!(0.25), 0)?);
/// # Ok::<(), fixstep::Error>(())
/// ```
#[inline]
pub fn drift_half<B: Body, H: TimeStep<B::S>>(bodies: &mut [B], now: &Now<H>) {
    each(bodies, |body| body.drift_half(&now.step));
}

/// Stage: velocities lose what drags take from them in `part` of the step.
///
/// ```
/// use fixstep::{Now, Part, integrate::{damp, kick}, prelude::*};
/// let mut bodies = [Point::<f64>::new(vec2(0, 0)?, vec2(1, 0)?, 1)?];
/// let (step, mut drag) = (Step::hz(10)?, ExactDrag::new(5)?);
/// let now = Now::start(&step, 0);
/// kick(&[], &mut bodies, &mut drag, &now); // prepares the drag, which kicks nothing
/// damp(&mut bodies, &mut drag, &now, Part::Whole);
/// assert!((bodies[0].velocity().x - (-0.5_f64).exp()).abs() < 1e-12); // k h / m = 0.5
/// # Ok::<(), fixstep::Error>(())
/// ```
#[inline]
pub fn damp<B: Body, F: Force<B>, H: TimeStep<B::S>>(
    bodies: &mut [B],
    forces: &mut F,
    now: &Now<H>,
    part: Part,
) {
    each(bodies, |body| forces.damp(now, part, body));
}

/// Every body is moved through `part` of the step: by a flow that has it, else by its own drift.
#[inline]
fn advance<B: Body, F: Force<B>, H: TimeStep<B::S>, const N: usize>(
    ids: &[BodyId],
    bodies: &mut [B],
    forces: &mut F,
    now: &Now<H>,
    part: Part,
) {
    let mut moved = [false; N];
    if F::FLOWS {
        forces.flow(now, part, &mut Frame::new(ids, bodies), &mut moved);
    }
    let mut moved = moved.iter();
    each(bodies, |body| match part {
        _ if F::FLOWS && moved.next() == Some(&true) => {}
        Part::Whole => body.drift(&now.step),
        _ => body.drift_half(&now.step),
    });
}

/// Fills `seen` with the bodies, which it has room for.
#[inline]
fn copy<B: Body, const N: usize>(bodies: &[B], seen: &mut heapless::Vec<B, N>) {
    seen.clear();
    for &body in bodies {
        let _ = seen.push(body);
    }
}

/// `f` on every body. Counts bodies, not addresses: from a loop over addresses the compiler
/// divides by the size of a body before it unrolls. That is slow on a core that cannot divide.
#[inline(always)]
fn each<B>(bodies: &mut [B], mut f: impl FnMut(&mut B)) {
    let mut tail = bodies;
    while let Some((body, behind)) = tail.split_first_mut() {
        f(body);
        tail = behind;
    }
}

/// Six registers: a point of 32 bits (20 bytes) stays where it is, a carried one (32) is moved.
const FEW_BYTES: usize = 24;

/// The same for a loop that kicks and drifts. A body of many words is taken out and put back: a word that
/// is stored in the middle keeps the compiler from loading and storing the others together.
#[inline(always)]
fn each_whole<B: Body>(bodies: &mut [B], mut f: impl FnMut(&mut B)) {
    each(bodies, |body| {
        if size_of::<B>() <= FEW_BYTES {
            return f(body);
        }
        let mut whole = *body;
        f(&mut whole);
        *body = whole;
    });
}
