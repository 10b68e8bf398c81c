//! The bodies of a world: in the order in which they were added, each with an id that is given once.

use super::World;
use crate::body::Body;
use crate::body::id::{self, BodyId, Stale};
use crate::error::Full;

impl<B: Body, const N: usize> World<B, N> {
    /// Adds a body after the others. A full world returns the body inside the error.
    ///
    /// ```
    /// use fixstep::{Point, World, vec2};
    /// let mut world = World::<Point<f32>, 1>::new();
    /// let ball = Point::new(vec2(0, 10)?, vec2(3, 0)?, 1)?;
    /// let id = world.add(ball)?;
    /// assert_eq!(world.get(id)?, &ball);
    /// assert_eq!(world.add(ball).unwrap_err().body, ball); // room for one
    /// # Ok::<(), fixstep::Error>(())
    /// ```
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

    /// The id of the next body; `None` if all ids are used.
    pub(crate) fn next_id(&self) -> Option<BodyId> {
        self.next
    }

    /// Restores a body with its id; `None` if ids would not rise.
    pub(crate) fn put_back(&mut self, id: BodyId, body: B) -> Option<()> {
        if self.ids.last().is_some_and(|&last| last >= id) {
            return None;
        }
        self.bodies.push(body).ok()?;
        let _ = self.ids.push(id);
        Some(())
    }

    /// Sets the tick and the next id; `None` if `next` is not above all ids in the world.
    pub(crate) fn go_on_from(&mut self, tick: u64, next: Option<BodyId>) -> Option<()> {
        let given = self.ids.last().copied();
        if next.is_some_and(|next| given.is_some_and(|given| given >= next)) {
            return None;
        }
        (self.tick, self.next) = (tick, next);
        Some(())
    }

    /// Removes a body and returns it. The bodies after it move up by one index. A stale id is an error.
    ///
    /// ```
    /// # use fixstep::{Point, World, vec2};
    /// # let mut world = World::<Point<f32>, 1>::new();
    /// # let ball = Point::new(vec2(0, 10)?, vec2(3, 0)?, 1)?;
    /// let id = world.add(ball)?;
    /// assert_eq!(world.remove(id)?, ball);
    /// assert!(world.is_empty() && world.remove(id).is_err());
    /// # Ok::<(), fixstep::Error>(())
    /// ```
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

    /// Removes all bodies. It keeps the tick, and no id is given again.
    pub fn clear(&mut self) {
        self.ids.clear();
        self.bodies.clear();
    }

    /// The index of a body in [`bodies`](World::bodies) and [`ids`](World::ids). Use it for your own
    /// arrays in the same order. A stale id is an error.
    pub fn index_of(&self, id: BodyId) -> Result<usize, Stale> {
        id::position(&self.ids, id).ok_or(Stale(id))
    }

    /// The body with this id. A stale id is an error.
    pub fn get(&self, id: BodyId) -> Result<&B, Stale> {
        self.bodies.get(self.index_of(id)?).ok_or(Stale(id))
    }

    /// The body with this id, to change it between steps. A stale id is an error.
    ///
    /// ```
    /// # use fixstep::{Point, World, vec2};
    /// # let mut world = World::<Point<f32>, 1>::new();
    /// # let ball = Point::new(vec2(0, 10)?, vec2(3, 0)?, 1)?;
    /// let id = world.add(ball)?;
    /// world.get_mut(id)?.set_velocity(vec2(0, 4)?)?;
    /// assert_eq!(world.get(id)?.velocity(), vec2(0, 4)?);
    /// # Ok::<(), fixstep::Error>(())
    /// ```
    pub fn get_mut(&mut self, id: BodyId) -> Result<&mut B, Stale> {
        let index = self.index_of(id)?;
        self.bodies.get_mut(index).ok_or(Stale(id))
    }

    /// Every body with its id, in the order in which they were added.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = (BodyId, &B)> {
        self.ids.iter().copied().zip(&self.bodies)
    }

    /// Every body with its id, to change it between steps.
    pub fn iter_mut(&mut self) -> impl ExactSizeIterator<Item = (BodyId, &mut B)> {
        self.ids.iter().copied().zip(&mut self.bodies)
    }

    /// The ids, in rising order. `ids()[i]` is the id of `bodies()[i]`.
    #[must_use]
    pub fn ids(&self) -> &[BodyId] {
        &self.ids
    }

    /// The bodies, for reports and for stages that you call yourself.
    #[must_use]
    pub fn bodies(&self) -> &[B] {
        &self.bodies
    }

    /// Number of bodies.
    #[must_use]
    pub fn len(&self) -> usize {
        self.bodies.len()
    }

    /// Whether the world has no bodies.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.bodies.is_empty()
    }
}
