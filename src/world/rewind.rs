//! Undo of steps: [`World::step_back`] undoes the last step, to the bit.
//!
//! | what cannot be undone | what happens |
//! |---|---|
//! | sums that round: `f32`, `f64` | does not compile |
//! | forces that read velocities: drags, functions without [`PositionOnly`](crate::PositionOnly) | does not compile |
//! | damping in a [`Spring`](crate::Spring) (also [`Attached`](crate::rigid::torque::Attached)) or an [`Anchor`](crate::Anchor) | [`RewindError::Damped`] |
//! | methods that are not symmetric in time: [`Euler`](crate::Euler), [`ConstantAcceleration`](crate::ConstantAcceleration), [`Rk4`](crate::Rk4) | does not compile |
//! | remainders of a [`Carried`](crate::Carried) body | does not compile |
//! | saturation, at any time | a plain point does not compile, [`RangeChecked`] returns [`RewindError::Saturated`] |
//!
//! Pass the same method, timestep and forces as in the step. Undo your own changes yourself: apply the
//! opposite impulse at the same tick. Bodies added or removed since then stay added or removed; only a
//! clone of the world undoes that.
//!
//! It works on a copy of the bodies, so an error changes nothing. The module
//! [`integrate`](crate::integrate) has the proof and the source.
//!
//! ```
//! use fixstep::{GravityY, Point, RangeChecked, Step, Verlet, World, fixed::types::I16F16, vec2};
//! let mut world = World::<RangeChecked<Point<I16F16>>, 1>::new();
//! let ball = RangeChecked::new(Point::new(vec2(0, 2)?, vec2(3, 0)?, 1)?);
//! let id = world.add(ball)?;
//! world.step(&mut Verlet, &mut GravityY::new(-8)?, &Step::hz(60)?);
//! world.step_back(&mut Verlet, &mut GravityY::new(-8)?, &Step::hz(60)?).unwrap();
//! assert_eq!((world.tick(), world.get(id)?), (0, &ball));
//! # Ok::<(), fixstep::Error>(())
//! ```

use core::fmt;

use crate::body::id::BodyId;
use crate::body::{Body, RangeChecked, Reverse};
use crate::force::Reversible;
use crate::integrate::Rewinds;
use crate::time::TimeStep;
use crate::world::World;

/// Why a step was not undone. The world is unchanged.
///
/// ```
/// use fixstep::{GravityY, Point, RangeChecked, RewindError, Step, Verlet, World, fixed::types::I16F16};
/// let mut world = World::<RangeChecked<Point<I16F16>>, 1>::new();
/// let result = world.step_back(&mut Verlet, &mut GravityY::new(-8)?, &Step::hz(60)?);
/// assert_eq!(result, Err(RewindError::AtStart));
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum RewindError {
    /// The world is at tick 0.
    AtStart,
    /// A sum of this body has saturated since it is checked, or would saturate in the undo. The undo
    /// adds the forces in the same order, but starts from the later velocity.
    Saturated {
        /// Its id.
        body: BodyId,
    },
    /// A force with damping was part of the step; it reads velocities.
    Damped {
        /// The name of the force's type.
        force: &'static str,
    },
}

impl fmt::Display for RewindError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::AtStart => {
                f.write_str("tick 0 is out of range: a step can be undone from tick 1")
            }
            Self::Saturated { body } => {
                let serial = body.serial();
                write!(f, "body {serial} has saturated: its steps cannot be undone")
            }
            Self::Damped { force } => {
                write!(f, "force {force} has damping: its steps cannot be undone")
            }
        }
    }
}

impl core::error::Error for RewindError {}

impl<B: Body, const N: usize> World<RangeChecked<B>, N> {
    /// Undoes the last step: positions, velocities and tick become what they were before, to the bit.
    /// Pass the same method, forces and timestep as in the step.
    ///
    /// It is an error at tick 0, if a body is [marked](RangeChecked::was_outside) and if a force has damping.
    ///
    /// ```
    /// use fixstep::{dec, vec2, GravityY, Point, Step, Verlet, RangeChecked, World, fixed::types::I16F16};
    /// let mut world = World::<RangeChecked<Point<I16F16>>, 1>::new();
    /// world.add(RangeChecked::new(Point::new(vec2(0, 2)?, vec2(12, 9)?, 1)?)).unwrap();
    /// let (start, step) = (world.state_hash(), Step::hz(60)?);
    /// let mut gravity = GravityY::new(dec!(-9.81))?;
    /// for _ in 0..1000 {
    ///     world.step(&mut Verlet, &mut gravity, &step);
    /// }
    /// for _ in 0..1000 {
    ///     world.step_back(&mut Verlet, &mut gravity, &step).unwrap();
    /// }
    /// assert_eq!(world.state_hash(), start);
    /// # Ok::<(), fixstep::Error>(())
    /// ```
    ///
    /// Types whose steps cannot be undone do not compile. This compiles:
    ///
    /// ```
    /// # use fixstep::{*, fixed::types::I16F16};
    /// # let step = Step::hz(60)?;
    /// let mut world = World::<RangeChecked<Point<I16F16>>, 1>::new();
    /// # let point = Point::new(Vec2::ZERO, Vec2::ZERO, 1)?;
    /// # world.add(RangeChecked::new(point)).unwrap();
    /// let (mut method, mut forces) = (Verlet, GravityY::new(-8)?);
    /// world.step(&mut method, &mut forces, &step);
    /// world.step_back(&mut method, &mut forces, &step).unwrap();
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// Drag does not compile:
    ///
    /// ```compile_fail,E0277
    /// # use fixstep::{*, fixed::types::I16F16};
    /// # let step = Step::hz(60)?;
    /// let mut world = World::<RangeChecked<Point<I16F16>>, 1>::new();
    /// # let point = Point::new(Vec2::ZERO, Vec2::ZERO, 1)?;
    /// # world.add(RangeChecked::new(point)).unwrap();
    /// let (mut method, mut forces) = (Verlet, LinearDrag::new(1)?);
    /// world.step(&mut method, &mut forces, &step);
    /// world.step_back(&mut method, &mut forces, &step).unwrap();
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// Floats do not compile:
    ///
    /// ```compile_fail,E0277
    /// # use fixstep::{*, fixed::types::I16F16};
    /// # let step = Step::hz(60)?;
    /// let mut world = World::<RangeChecked<Point<f32>>, 1>::new();
    /// # let point = Point::new(Vec2::ZERO, Vec2::ZERO, 1)?;
    /// # world.add(RangeChecked::new(point)).unwrap();
    /// let (mut method, mut forces) = (Verlet, GravityY::new(-8)?);
    /// world.step(&mut method, &mut forces, &step);
    /// world.step_back(&mut method, &mut forces, &step).unwrap();
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// A method that is not symmetric in time does not compile:
    ///
    /// ```compile_fail,E0277
    /// # use fixstep::{*, fixed::types::I16F16};
    /// # let step = Step::hz(60)?;
    /// let mut world = World::<RangeChecked<Point<I16F16>>, 1>::new();
    /// # let point = Point::new(Vec2::ZERO, Vec2::ZERO, 1)?;
    /// # world.add(RangeChecked::new(point)).unwrap();
    /// let (mut method, mut forces) = (Euler::new(), GravityY::new(-8)?);
    /// world.step(&mut method, &mut forces, &step);
    /// world.step_back(&mut method, &mut forces, &step).unwrap();
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// A body that does not record saturation does not compile:
    ///
    /// ```compile_fail,E0599
    /// # use fixstep::{*, fixed::types::I16F16};
    /// # let step = Step::hz(60)?;
    /// let mut world = World::<Point<I16F16>, 1>::new();
    /// # let point = Point::new(Vec2::ZERO, Vec2::ZERO, 1)?;
    /// # world.add(point).unwrap();
    /// let (mut method, mut forces) = (Verlet, GravityY::new(-8)?);
    /// world.step(&mut method, &mut forces, &step);
    /// world.step_back(&mut method, &mut forces, &step).unwrap();
    /// # Ok::<(), Error>(())
    /// ```
    pub fn step_back<M, F, H>(
        &mut self,
        method: &mut M,
        forces: &mut F,
        step: &H,
    ) -> Result<(), RewindError>
    where
        B: Reverse,
        M: Rewinds<RangeChecked<B>, N>,
        F: Reversible<RangeChecked<B>>,
        H: TimeStep<B::S>,
    {
        const { assert!(!F::FLOWS, "a flow rounds, and is not undone") };
        let (ids, bodies, now) = self.state();
        let tick = now.checked_sub(1).ok_or(RewindError::AtStart)?;
        if let Some(force) = forces.damper(tick) {
            return Err(RewindError::Damped { force });
        }
        let mut back = bodies.clone();
        method.step_back(ids, &mut back, forces, step, tick);
        // Marks stay, so this also finds those from the steps forward.
        inside(ids, &back)?;
        (*bodies, *now) = (back, tick);
        Ok(())
    }
}

/// An error with the first body that is marked.
fn inside<B: Body>(ids: &[BodyId], bodies: &[RangeChecked<B>]) -> Result<(), RewindError> {
    let marked = ids.iter().zip(bodies).find(|(_, body)| body.was_outside());
    marked.map_or(Ok(()), |(&body, _)| Err(RewindError::Saturated { body }))
}
