//! A world that goes back: [`World::step_back`] undoes a step, to the bit.
//!
//! | what breaks it | how it is refused |
//! |---|---|
//! | sums that round: `f32`, `f64` | does not compile |
//! | forces that read velocities: drags, functions without [`PositionOnly`](crate::PositionOnly) | does not compile |
//! | a [`Spring`](crate::Spring), [`Attached`](crate::rigid::torque::Attached) or not, or [`Anchor`](crate::Anchor) with damping | [`RewindError::Damped`] |
//! | methods that are no mirror image of one: [`Euler`](crate::Euler), [`ConstantAcceleration`](crate::ConstantAcceleration), [`Rk4`](crate::Rk4) | does not compile |
//! | bodies whose remainders a turn would not lead back: [`Carried`](crate::Carried) | does not compile |
//! | saturation, at any time | a plain point does not compile, [`RangeChecked`] says [`RewindError::Saturated`] |
//!
//! The scene hands in the method, the step and the forces that the steps were made with, and undoes by
//! hand what it has done by hand: an impulse by the opposite one, at the tick at which it was given.
//! Bodies that were added or removed since stay as they are; a clone of the world undoes that.
//!
//! It works in a copy of the bodies, so that a refusal changes nothing. The module
//! [`integrate`](crate::integrate) says why it leads back, and the source.

use core::fmt;

use crate::body::id::BodyId;
use crate::body::{Body, RangeChecked, Reverse};
use crate::force::Reversible;
use crate::integrate::Rewinds;
use crate::time::TimeStep;
use crate::world::World;

/// Why a step was not undone. The world is as it was.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum RewindError {
    /// The world is at tick 0.
    AtStart,
    /// A sum of this body has saturated since it is watched, or would on the way back, where forces in
    /// the same order add up from the other end.
    Saturated {
        /// Its name.
        body: BodyId,
    },
    /// A force read velocities in the step that was to be undone.
    Damped {
        /// The name of its type.
        force: &'static str,
    },
}

impl fmt::Display for RewindError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::AtStart => f.write_str("a world at tick 0 has no step to undo"),
            Self::Saturated { body } => {
                let serial = body.serial();
                write!(
                    f,
                    "body {serial} left the range: its steps cannot be undone"
                )
            }
            Self::Damped { force } => {
                write!(f, "{force} has damping: its steps cannot be undone")
            }
        }
    }
}

impl core::error::Error for RewindError {}

impl<B: Body, const N: usize> World<RangeChecked<B>, N> {
    /// Undoes the last step: positions, velocities and tick are what they were before it, to the bit.
    /// Takes the method, the forces and the step that it was made with.
    ///
    /// Refuses at tick 0, where a body is [marked](RangeChecked::was_outside), and where a force has damping.
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
    /// Types that cannot go back do not compile. This goes back:
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
    /// with drag it does not,
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
    /// nor in floats,
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
    /// nor by another method,
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
    /// nor with a body that keeps no books.
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
        // Marks stay, so this finds those of the way out too.
        inside(ids, &back)?;
        (*bodies, *now) = (back, tick);
        Ok(())
    }
}

/// Names the first body that is marked.
fn inside<B: Body>(ids: &[BodyId], bodies: &[RangeChecked<B>]) -> Result<(), RewindError> {
    let marked = ids.iter().zip(bodies).find(|(_, body)| body.was_outside());
    marked.map_or(Ok(()), |(&body, _)| Err(RewindError::Saturated { body }))
}
