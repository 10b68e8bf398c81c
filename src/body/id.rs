//! Ids of bodies: serial numbers that a world never gives twice.
//!
//! Bodies are stored densely, in the order in which they were added. So their serial numbers rise, and a
//! binary search finds one. A stale id never finds another body, however often its index was used again:
//! there is no generation counter that could wrap. After `2^32` additions a world is full.
//!
//! This holds within one history of one world. A world restored from a clone gives the later serial
//! numbers a second time. Ids of two worlds can be equal.

use core::fmt;

use crate::error::Error;

/// The permanent id of one body in one world.
///
/// ```
/// use fixstep::{Point, World, vec2};
/// let mut world = World::<Point<f32>, 2>::new();
/// let ball = Point::new(vec2(0, 0)?, vec2(0, 0)?, 1)?;
/// let (first, second) = (world.add(ball)?, world.add(ball)?);
/// assert_eq!((first.serial(), second.serial()), (0, 1));
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BodyId(u32);

impl BodyId {
    /// The first id of a world.
    pub(crate) const FIRST: BodyId = BodyId(0);

    /// The id after this one; `None` after the last.
    pub(crate) fn next(self) -> Option<BodyId> {
        self.0.checked_add(1).map(BodyId)
    }

    pub(crate) fn from_serial(serial: u32) -> BodyId {
        BodyId(serial)
    }

    /// The serial number: 0 for the first body that was added.
    #[must_use]
    pub fn serial(self) -> u32 {
        self.0
    }
}

/// The error for an id whose body is not in the world, or not any more.
///
/// ```
/// use fixstep::{Point, Stale, World, vec2};
/// let mut world = World::<Point<f32>, 1>::new();
/// let id = world.add(Point::new(vec2(0, 0)?, vec2(0, 0)?, 1)?)?;
/// world.clear();
/// assert_eq!(world.get(id), Err(Stale(id)));
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stale(
    /// The id of the body.
    pub BodyId,
);

impl fmt::Display for Stale {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Error::from(*self).fmt(f)
    }
}

impl core::error::Error for Stale {}

impl From<Stale> for Error {
    fn from(stale: Stale) -> Error {
        let serial = stale.0.serial();
        Error::Stale { serial }
    }
}

/// The index of `id` in `ids`, which rise.
#[inline]
pub(crate) fn position(ids: &[BodyId], id: BodyId) -> Option<usize> {
    ids.binary_search(&id).ok()
}
