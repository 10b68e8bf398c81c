//! The bodies that forces read, and those that they push.

use crate::body::Body;
use crate::body::id::{self, BodyId};

/// Bodies to read and the same bodies to push, in the order of their ids.
///
/// They are one array where a force sees the changes of the forces before it. They are two arrays where all
/// forces act from one instant.
///
/// ```
/// use fixstep::{Body, Frame, prelude::*};
/// let mut world = World::<Point<f32>, 1>::new();
/// let id = world.add(Point::new(vec2(0, 0)?, vec2(0, 0)?, 1)?)?;
/// let (ids, mut bodies) = (world.ids(), [world.bodies()[0]]);
/// let mut frame = Frame::new(ids, &mut bodies);
/// let (index, seen) = frame.find(id).unwrap();
/// assert_eq!(seen.position(), Vec2::ZERO);
/// frame.live_at(index).unwrap().kick(vec2(3, 0)?);
/// assert_eq!(bodies[0].velocity(), vec2(3, 0)?);
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Debug)]
pub struct Frame<'a, B> {
    ids: &'a [BodyId],
    seen: Option<&'a [B]>,
    live: &'a mut [B],
}

impl<'a, B: Body> Frame<'a, B> {
    /// Forces read and push the same bodies.
    #[must_use]
    pub fn new(ids: &'a [BodyId], bodies: &'a mut [B]) -> Self {
        Frame {
            ids,
            seen: None,
            live: bodies,
        }
    }

    /// Forces read `seen` and push `live`: two copies of the same bodies.
    #[must_use]
    pub fn split(ids: &'a [BodyId], seen: &'a [B], live: &'a mut [B]) -> Self {
        Frame {
            ids,
            seen: Some(seen),
            live,
        }
    }

    /// The bodies as forces are to see them.
    #[inline]
    #[must_use]
    pub fn bodies(&self) -> &[B] {
        self.seen.unwrap_or(self.live)
    }

    /// The index of the body with this id, and the body as forces see it.
    #[inline]
    #[must_use]
    pub fn find(&self, id: BodyId) -> Option<(usize, B)> {
        let index = id::position(self.ids, id)?;
        Some((index, *self.bodies().get(index)?))
    }

    /// The index of the body with this id. Not inlined where size counts.
    pub(crate) fn index_of(&self, id: BodyId) -> Option<usize> {
        id::position(self.ids, id)
    }

    /// The two bodies at these indices, to read and to push. `None` if the indices are equal or out of range.
    #[inline]
    pub(crate) fn pair(&mut self, i: usize, j: usize) -> Option<([B; 2], [&mut B; 2])> {
        let apart = self.seen;
        let live = self.live_pair(i, j)?;
        let seen = match apart {
            None => [*live[0], *live[1]],
            Some(seen) => [*seen.get(i)?, *seen.get(j)?],
        };
        Some((seen, live))
    }

    /// The bodies to push, in the same order.
    #[inline]
    pub fn live(&mut self) -> &mut [B] {
        self.live
    }

    /// The body to push at this index.
    #[inline]
    pub fn live_at(&mut self, index: usize) -> Option<&mut B> {
        self.live.get_mut(index)
    }

    /// The two bodies to push at these indices. `None` if the indices are equal or out of range.
    #[inline]
    pub fn live_pair(&mut self, i: usize, j: usize) -> Option<[&mut B; 2]> {
        self.live.get_disjoint_mut([i, j]).ok()
    }
}
