//! The arrays, and one default way through the stages.
//!
//! A world holds bodies, their ids and the tick: nothing else, so that a clone is a snapshot.
//! Forces, step and method stay outside; a scene hands them in.

mod fnv;
mod measure;
pub mod rewind;
pub mod snapshot;

use crate::body::Body;
use crate::body::id::{self, BodyId, Stale};
use crate::error::Full;
use crate::force::Force;
use crate::integrate::Method;
use crate::time::Between;
use crate::time::TimeStep;
use crate::time::{Now, Time};
use crate::vec2::Vec2;

/// Up to `N` bodies, in the order in which they were added.
///
/// `new` is `const`: a world can live in a `static`.
///
/// ```
/// use fixstep::{vec2, Point, Stale, World, fixed::types::I16F16};
/// let mut world = World::<Point<I16F16>, 1>::new();
/// let ball = Point::new(vec2(0, 10)?, vec2(3, 0)?, 1)?;
/// let id = world.add(ball).unwrap();
/// assert_eq!(world.add(ball).unwrap_err().body, ball); // full: the body comes back
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
    /// Adds a body behind the others. A full world gives it back.
    #[inline(always)]
    pub fn add(&mut self, body: B) -> Result<BodyId, Full<B>> {
        let Some(id) = self.next else {
            return Err(Full::new(body, N));
        };
        self.bodies.push(body).map_err(|body| Full::new(body, N))?;
        // Both arrays have the same room.
        let _ = self.ids.push(id);
        self.next = id.next();
        Ok(id)
    }

    /// The id that the next body gets; `None` when there are no more.
    pub(crate) fn next_id(&self) -> Option<BodyId> {
        self.next
    }

    /// Puts a body back under the name it had; `None` where names would not rise.
    pub(crate) fn put_back(&mut self, id: BodyId, body: B) -> Option<()> {
        if self.ids.last().is_some_and(|&last| last >= id) {
            return None;
        }
        self.bodies.push(body).ok()?;
        let _ = self.ids.push(id);
        Some(())
    }

    /// Sets the clock and the next name; `None` for a name that a body has, or will have.
    pub(crate) fn go_on_from(&mut self, tick: u64, next: Option<BodyId>) -> Option<()> {
        let given = self.ids.last().copied();
        if next.is_some_and(|next| given.is_some_and(|given| given >= next)) {
            return None;
        }
        (self.tick, self.next) = (tick, next);
        Some(())
    }

    /// Takes a body out; those behind it move up. Refuses a stale id.
    pub fn remove(&mut self, id: BodyId) -> Result<B, Stale> {
        let gone = *self.get(id)?;
        self.retain(|other, _| other != id);
        Ok(gone)
    }

    /// Keeps the bodies for which `keep` is true, in their order.
    pub fn retain(&mut self, mut keep: impl FnMut(BodyId, &B) -> bool) {
        let mut kept = 0;
        for i in 0..self.bodies.len() {
            let (Some(&id), Some(&body)) = (self.ids.get(i), self.bodies.get(i)) else {
                break;
            };
            if keep(id, &body) {
                if let (Some(to_id), Some(to)) = (self.ids.get_mut(kept), self.bodies.get_mut(kept))
                {
                    (*to_id, *to) = (id, body);
                }
                kept += 1;
            }
        }
        self.ids.truncate(kept);
        self.bodies.truncate(kept);
    }

    /// Takes all bodies out. The tick goes on, and no id is given again.
    pub fn clear(&mut self) {
        self.ids.clear();
        self.bodies.clear();
    }

    /// Where the body of that name stands in [`bodies`](World::bodies) and [`ids`](World::ids), for
    /// arrays of your own beside them. Refuses a stale id.
    pub fn index_of(&self, id: BodyId) -> Result<usize, Stale> {
        id::position(&self.ids, id).ok_or(Stale(id))
    }

    /// The body of that name. Refuses a stale id.
    pub fn get(&self, id: BodyId) -> Result<&B, Stale> {
        self.bodies.get(self.index_of(id)?).ok_or(Stale(id))
    }

    /// The body of that name, to be changed between steps. Refuses a stale id.
    pub fn get_mut(&mut self, id: BodyId) -> Result<&mut B, Stale> {
        let index = self.index_of(id)?;
        self.bodies.get_mut(index).ok_or(Stale(id))
    }

    /// Every body with its id, in the order in which they were added.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = (BodyId, &B)> {
        self.ids.iter().copied().zip(&self.bodies)
    }

    /// Every body with its id, to be changed between steps.
    pub fn iter_mut(&mut self) -> impl ExactSizeIterator<Item = (BodyId, &mut B)> {
        self.ids.iter().copied().zip(&mut self.bodies)
    }

    /// The ids, rising; body `i` of [`bodies`](World::bodies) has id `i`.
    #[must_use]
    pub fn ids(&self) -> &[BodyId] {
        &self.ids
    }

    /// The bodies, for stages called by hand and for reports.
    #[must_use]
    pub fn bodies(&self) -> &[B] {
        &self.bodies
    }

    /// Number of bodies.
    #[must_use]
    pub fn len(&self) -> usize {
        self.bodies.len()
    }

    /// Whether there is no body.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.bodies.is_empty()
    }

    /// Number of steps made.
    #[must_use]
    pub fn tick(&self) -> u64 {
        self.tick
    }

    /// Makes one step.
    #[inline]
    pub fn step<M, F, H>(&mut self, method: &mut M, forces: &mut F, step: &H)
    where
        M: Method<B, N>,
        F: Force<B>,
        H: TimeStep<B::S>,
    {
        method.step(&self.ids, &mut self.bodies, forces, step, self.tick);
        // Comes round after 2^64 steps: at 1 kHz, 600 million years.
        self.tick = self.tick.wrapping_add(1);
    }

    /// All that a step changes, and the names of the bodies.
    pub(crate) fn state(&mut self) -> (&[BodyId], &mut heapless::Vec<B, N, u32>, &mut u64) {
        (&self.ids, &mut self.bodies, &mut self.tick)
    }

    /// Where to draw each body at a part of the step that led from `before` to here, by the formula
    /// of `method`. A body that was not there before is drawn where it is.
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

    /// The time since tick 0, if every step was a `step`.
    pub fn time(&self, step: &impl TimeStep<B::S>) -> Time {
        Now::start(step, self.tick).time()
    }

    /// The bodies that stand at an end of the range, or are NaN or infinite, now.
    ///
    /// It looks at the state as it is, so look after every step that matters: a saturated spring may
    /// throw its body back. An impulse saturates too, which shows only in where the body goes: what is
    /// unstable (explicit drag, `Rk4`) may swing inside the range for ever. A
    /// [`RangeChecked`](crate::RangeChecked) body remembers each sum that did reach the end.
    pub fn out_of_range(&self) -> impl Iterator<Item = BodyId> {
        self.iter()
            .filter(|(_, body)| !body.is_inside())
            .map(|(id, _)| id)
    }
}
