//! Names of bodies: serial numbers that are never given twice.
//!
//! Bodies lie densely, in the order in which they were added, so their serial numbers rise and a
//! search by halving finds one. A stale id finds nothing, however often its place was used again:
//! there is no generation counter that could come round. After `2^32` additions a world is full.
//!
//! That holds within one history of one world. A clone that is put back gives the serial numbers
//! since then a second time, and the ids of another world look the same.

use core::fmt;

use crate::error::Error;

/// Names one body of one world, for ever.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BodyId(u32);

impl BodyId {
    /// The first id of a world.
    pub(crate) const FIRST: BodyId = BodyId(0);

    /// The id after this one; `None` when there are no more.
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

/// The body of that name is not in the world, or no more.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stale(
    /// Its name.
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

/// Where `id` stands in `ids`, which rise.
#[inline]
pub(crate) fn position(ids: &[BodyId], id: BodyId) -> Option<usize> {
    ids.binary_search(&id).ok()
}
