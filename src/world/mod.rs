//! The world: arrays of bodies, and a step that runs the stages of a method.
//!
//! A world holds bodies, their ids and the tick, and nothing else. So a clone is a snapshot.
//! Forces, timestep and method stay outside; you pass them to each step.
//!
//! ```
//! use fixstep::{Point, SemiImplicitEuler, Step, World, vec2};
//! let mut world = World::<Point<f32>, 8>::new();
//! let id = world.add(Point::new(vec2(0, 0)?, vec2(6, 0)?, 1)?)?;
//! for _ in 0..60 {
//!     world.step(&mut SemiImplicitEuler, &mut (), &Step::hz(60)?); // no forces
//! }
//! assert!((world.get(id)?.position().x - 6.0).abs() < 1e-4); // 1 s at 6 m/s
//! # Ok::<(), fixstep::Error>(())
//! ```

mod bodies;
mod fnv;
mod measure;
pub mod rewind;
pub mod snapshot;

use crate::body::{Body, BodyId};
use crate::force::Force;
use crate::integrate::Method;
use crate::time::{Between, Now, Time, TimeStep};
use crate::vec2::Vec2;

/// Up to `N` bodies, in the order in which they were added.
///
/// `new` is `const`, so a world can be a `static`.
///
/// ```
/// use fixstep::{vec2, Point, Stale, World, fixed::types::I16F16};
/// let mut world = World::<Point<I16F16>, 1>::new();
/// let ball = Point::new(vec2(0, 10)?, vec2(3, 0)?, 1)?;
/// let id = world.add(ball).unwrap();
/// assert_eq!(world.add(ball).unwrap_err().body, ball); // full: the error has the body
/// assert_eq!(world.remove(id), Ok(ball));
/// assert_eq!(world.get(id), Err(Stale(id)));
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct World<B, const N: usize> {
    tick: u64,
    next: Option<BodyId>,
    // Lengths of 32 bits, so that a world has one size on every target.
    ids: heapless::Vec<BodyId, N, u32>,
    bodies: heapless::Vec<B, N, u32>,
}

impl<B, const N: usize> World<B, N> {
    /// An empty world at tick 0.
    #[must_use]
    pub const fn new() -> Self {
        World {
            tick: 0,
            next: Some(BodyId::FIRST),
            ids: heapless::Vec::new(),
            bodies: heapless::Vec::new(),
        }
    }
}

impl<B, const N: usize> Default for World<B, N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<B: Body, const N: usize> World<B, N> {
    /// Number of steps made.
    #[must_use]
    pub fn tick(&self) -> u64 {
        self.tick
    }

    /// Makes one step: `method` integrates all bodies with `forces` over `step`.
    ///
    /// ```
    /// use fixstep::{DyadicStep, GravityY, Point, Verlet, World, vec2};
    /// let mut world = World::<Point<f32>, 1>::new();
    /// let id = world.add(Point::new(vec2(0, 9)?, vec2(0, 0)?, 1)?)?;
    /// let step = DyadicStep::<f32, 1, 1>::new()?; // 1/2 s
    /// world.step(&mut Verlet, &mut GravityY::new(-8)?, &step);
    /// let ball = world.get(id)?; // h g = -4 m/s, h² g / 2 = -1 m
    /// assert_eq!((ball.velocity(), ball.position()), (vec2(0, -4)?, vec2(0, 8)?));
    /// # Ok::<(), fixstep::Error>(())
    /// ```
    #[inline]
    pub fn step<M, F, H>(&mut self, method: &mut M, forces: &mut F, step: &H)
    where
        M: Method<B, N>,
        F: Force<B>,
        H: TimeStep<B::S>,
    {
        method.step(&self.ids, &mut self.bodies, forces, step, self.tick);
        // Wraps after 2^64 steps: at 1 kHz, 600 million years.
        self.tick = self.tick.wrapping_add(1);
    }

    /// All that a step changes, and the ids of the bodies.
    pub(crate) fn state(&mut self) -> (&[BodyId], &mut heapless::Vec<B, N, u32>, &mut u64) {
        (&self.ids, &mut self.bodies, &mut self.tick)
    }

    /// The position at which to draw each body between two steps, by the formula of `method`.
    ///
    /// `before` is the world one step earlier. A body that it does not have is at its present position.
    ///
    /// ```
    /// use fixstep::{dec, vec2, Between, DyadicStep, GravityY, Point, Verlet, World};
    /// let step = DyadicStep::<f32, 1, 1>::new()?;
    /// let mut gravity = GravityY::new(-8)?;
    /// let mut world = World::<_, 1>::new();
    /// world.add(Point::new(vec2(0, 9)?, vec2(2, 0)?, 1)?).unwrap();
    /// let before = world.clone();
    /// world.step(&mut Verlet, &mut gravity, &step);
    /// let middle = Between::new(dec!(0.5), &step)?; // a quarter second after the start
    /// let (_, at) = world.between(&before, &Verlet, &middle).next().unwrap();
    /// assert_eq!(at, vec2(dec!(0.5), dec!(8.75))?);
    /// # Ok::<(), fixstep::Error>(())
    /// ```
    pub fn between<'a, M: Method<B, N>>(
        &'a self,
        before: &'a World<B, N>,
        method: &'a M,
        part: &'a Between<B::S>,
    ) -> impl Iterator<Item = (BodyId, Vec2<B::S>)> + 'a {
        self.iter().map(move |(id, after)| {
            let before = before.get(id).unwrap_or(after);
            (id, method.between(part, before, after))
        })
    }

    /// The time since tick 0, if every step was `step`.
    pub fn time(&self, step: &impl TimeStep<B::S>) -> Time {
        Now::start(step, self.tick).time()
    }

    /// The bodies that are now at an end of the range, or NaN or infinite.
    ///
    /// It tests the present state, so call it after every step that matters: a saturated spring may
    /// throw its body back inside. An impulse saturates too, and only the motion shows it. An unstable
    /// scene (explicit drag, `Rk4`) may oscillate inside the range for ever. A
    /// [`RangeChecked`](crate::RangeChecked) body remembers each sum that reached the end.
    ///
    /// ```
    /// # use fixstep::{Body, Point, Vec2, World};
    /// let mut world = World::<Point<f32>, 1>::new();
    /// let id = world.add(Point::new(Vec2::ZERO, Vec2::ZERO, 1)?)?;
    /// assert_eq!(world.out_of_range().next(), None);
    /// world.get_mut(id)?.kick(Vec2::new(f32::INFINITY, 0.0));
    /// assert_eq!(world.out_of_range().next(), Some(id));
    /// # Ok::<(), fixstep::Error>(())
    /// ```
    pub fn out_of_range(&self) -> impl Iterator<Item = BodyId> {
        self.iter()
            .filter(|(_, body)| !body.is_inside())
            .map(|(id, _)| id)
    }
}
