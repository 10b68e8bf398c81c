//! Which bodies a world holds: in the order in which they were added, each under an id that is given once.

use super::World;
use crate::body::Body;
use crate::body::id::{self, BodyId, Stale};
use crate::error::Full;

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
}
