//! A force says *what* it does to a body. The method decides *when*, and to which copy of the state.
//!
//! | force | acts on | cost |
//! |---|---|---|
//! | [`Gravity`] | every body, from itself | one addition an axis |
//! | [`GravityY`] | every body, from itself | one addition |
//! | [`LinearDrag`] | every body, from itself | a product and one more an axis |
//! | [`QuadraticDrag`] | every body, from itself | a square root, two products and one more an axis |
//! | [`PerBody`] | every body, from itself | your function, a product and one more an axis |
//! | [`Push`] | one body | a product and one more an axis |
//! | [`Anchor`] | one body | two products and two more an axis |
//! | [`Spring`] | two bodies | a square root, two or three divisions |
//! | [`Pull`] | two bodies | a square root, three divisions, nine products |
//! | [`AllBodies`] | every body, from all | your function, 8 bytes a body in the force |
//! | [`ExactDrag`] | every body, damped | a product an axis; an exponential where the mass changes |
//! | [`ExactQuadraticDrag`] | every body, damped | a square root, a division, two products and one more an axis |
//! | [`Ballistic`] | every body, instead of its drift | two products an axis; an exponential where the mass changes |
//! | [`ExactSpring`] | one body, instead of its drift | three products an axis, four if damped |
//! | [`ExactPair`] | two bodies, instead of their drift | five divisions, some products |
//!
//! [`Pairs`] and [`AllPairs`] choose the bodies between which a spring or a pull acts. A tuple of forces is a force. So is
//! an array, a `heapless::Vec` or an `Option` of one force. A [`Window`] limits a force to some steps.
//!
//! # How a force acts
//!
//! | function | sees | when |
//! |---|---|---|
//! | [`couple`](Force::couple) | all bodies | before the loop over the bodies |
//! | [`field`](Force::field) | one body | inside the loop that moves it |
//! | [`damp`](Force::damp) | one body | after the kicks, or half before and half after them |
//! | [`flow`](Force::flow) | all bodies | instead of the drift |
//!
//! A *kick* changes a velocity, a *drift* a position. A *flow* is an exact solution that replaces both for its bodies. A
//! body has one flow at most: the first in the tuple.
//!
//! # What to know
//!
//! * A force on one body multiplies by `h / m` and rounds the change of velocity once.
//! * A spring between two bodies makes an impulse in kg m/s, a scalar itself. With masses far from 1 kg its unit is
//!   coarse for the light body, and its range short for the heavy one.
//! * With `SemiImplicitEuler` and `Verlet` a force reads velocities that coupled forces have already changed. So drag
//!   brakes what a spring has just pushed. A body that hangs in both comes to rest lower, by about `k_drag h / m` of
//!   its sag.

mod all_bodies;
mod anchor;
mod drag;
mod exact;
mod frame;
mod gravity;
mod list;
mod memo;
mod pairs;
mod per_body;
mod per_step;
mod pull;
mod push;
mod quadratic_drag;
mod reversible;
mod spring;
mod window;

use crate::body::{Body, BodyId};
use crate::scalar::Factor;
use crate::time::{Now, TimeStep};
use crate::vec2::Vec2;

pub use all_bodies::AllBodies;
pub use anchor::Anchor;
pub use drag::LinearDrag;
pub use exact::{Ballistic, ExactDrag, ExactPair, ExactQuadraticDrag, ExactSpring};
pub use frame::Frame;
pub use gravity::{Gravity, GravityY};
pub use pairs::{AllPairs, PairForce, Pairs};
pub use per_body::{Effort, PerBody};
pub use per_step::{PerStep, coefficient, half};
pub use pull::Pull;
pub use push::Push;
pub use quadratic_drag::QuadraticDrag;
pub use reversible::{PositionOnly, Reversible, ReversiblePair};
pub use spring::Spring;
pub use window::Window;

pub(crate) use memo::Memo;
use per_step::is_none;

/// A part of a step, for work that a method does at once or in two halves around its kicks.
///
/// ```
/// use fixstep::Part;
/// // `SemiImplicitEuler` damps once, after its kick; `Verlet` half before its kick and half after it.
/// assert_ne!(Part::Whole, Part::FirstHalf);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// All of it.
    Whole,
    /// The half before the kicks.
    FirstHalf,
    /// The half after them.
    SecondHalf,
}

/// Something that changes velocities. A force implements the functions it needs.
///
/// ```
/// use fixstep::time::{Now, TimeStep};
/// use fixstep::{Force, prelude::*};
///
/// /// A wind that blows along x, stronger with height: an acceleration of `y / 4`.
/// struct Wind;
///
/// impl<B: Body<S = f32>> Force<B> for Wind {
///     const COUPLES: bool = false; // each body by itself
///
///     fn field<H: TimeStep<f32>>(&mut self, now: &Now<H>, seen: &B, live: &mut B) {
///         let acceleration = Vec2::new(seen.position().y / 4.0, 0.0);
///         live.kick_by(acceleration, now.step.coef());
///     }
/// }
///
/// let mut world = World::<Point<f32>, 1>::new();
/// let kite = world.add(Point::new(vec2(0, 8)?, vec2(0, 0)?, 1)?)?;
/// world.step(&mut SemiImplicitEuler, &mut Wind, &Step::hz(10)?);
/// assert!((world.get(kite)?.velocity().x - 0.2).abs() < 1e-6); // 2 m/s² for 1/10 s
/// # Ok::<(), fixstep::Error>(())
/// ```
pub trait Force<B: Body> {
    /// Whether [`couple`](Force::couple) does anything: methods skip it otherwise.
    const COUPLES: bool;

    /// Whether [`flow`](Force::flow) does anything: methods skip it otherwise.
    ///
    /// ```
    /// use fixstep::{ExactSpring, Point, SemiImplicitEuler, Step, World, vec2};
    /// let mut world = World::<_, 1>::new();
    /// let id = world.add(Point::<f32>::new(vec2(1, 0)?, vec2(0, 0)?, 1)?)?;
    /// let mut spring = ExactSpring::new(id, vec2(0, 0)?, 2, 0)?;
    /// world.step(&mut SemiImplicitEuler, &mut spring, &Step::hz(60)?);
    /// # Ok::<(), fixstep::Error>(())
    /// ```
    ///
    /// A flow replaces a drift. [`Euler`](crate::Euler) and
    /// [`ConstantAcceleration`](crate::ConstantAcceleration) drift by the velocity before the kick,
    /// and do not compile with one:
    ///
    /// ```compile_fail
    /// use fixstep::{Euler, ExactSpring, Point, Step, World, vec2};
    /// let mut world = World::<_, 1>::new();
    /// let id = world.add(Point::<f32>::new(vec2(1, 0)?, vec2(0, 0)?, 1)?)?;
    /// let mut spring = ExactSpring::new(id, vec2(0, 0)?, 2, 0)?;
    /// world.step(&mut Euler::new(), &mut spring, &Step::hz(60)?);
    /// # Ok::<(), fixstep::Error>(())
    /// ```
    ///
    /// ```compile_fail
    /// use fixstep::{ConstantAcceleration, ExactSpring, Point, Step, World, vec2};
    /// let mut world = World::<_, 1>::new();
    /// let id = world.add(Point::<f32>::new(vec2(1, 0)?, vec2(0, 0)?, 1)?)?;
    /// let mut spring = ExactSpring::new(id, vec2(0, 0)?, 2, 0)?;
    /// world.step(&mut ConstantAcceleration::new(), &mut spring, &Step::hz(60)?);
    /// # Ok::<(), fixstep::Error>(())
    /// ```
    const FLOWS: bool = false;

    /// Work that is the same for every body; called once before the others, for each evaluation.
    #[inline]
    fn prepare<H: TimeStep<B::S>>(&mut self, now: &Now<H>) {
        let _ = now;
    }

    /// Acts on bodies that it finds in `frame`.
    #[inline]
    fn couple<H: TimeStep<B::S>>(&mut self, now: &Now<H>, frame: &mut Frame<B>) {
        let _ = (now, frame);
    }

    /// Acts on one body, `live`, from its state `seen`.
    #[inline]
    fn field<H: TimeStep<B::S>>(&mut self, now: &Now<H>, seen: &B, live: &mut B) {
        let _ = (now, seen, live);
    }

    /// Takes from the velocity of one body what it loses in this part of the step: the exact
    /// solution of a drag that acts alone.
    #[inline]
    fn damp<H: TimeStep<B::S>>(&mut self, now: &Now<H>, part: Part, live: &mut B) {
        let _ = (now, part, live);
    }

    /// Moves bodies through this part of the step by the exact solution of their motion, instead of their drift.
    /// It marks each body that it moves in `moved`, and skips those that are marked already. It rotates the bodies
    /// that it moves by [`Body::drift_angle`] or [`Body::drift_angle_half`].
    #[inline]
    fn flow<H: TimeStep<B::S>>(
        &mut self,
        now: &Now<H>,
        part: Part,
        frame: &mut Frame<B>,
        moved: &mut [bool],
    ) {
        let _ = (now, part, frame, moved);
    }

    /// Potential energy of `bodies` in this force, J; zero for a force that has none.
    #[must_use]
    fn potential(&self, ids: &[BodyId], bodies: &[B]) -> f64 {
        let _ = (ids, bodies);
        0.0
    }
}

/// `-sum(m g·x)`: the potential energy in an acceleration that is the same everywhere.
fn potential<B: Body>(acceleration: Vec2<B::S>, bodies: &[B]) -> f64 {
    let g = acceleration.to_f64();
    bodies
        .iter()
        .filter(|body| !body.has_infinite_mass())
        .map(|body| -g.dot(body.position().to_f64()) / body.inv_mass().to_f64())
        .sum()
}
