//! Saves a world as bytes and loads it: for a save file, rollback over a network, a crash dump.
//!
//! ```
//! use fixstep::{Point, World};
//! let mut bytes = [0; 40];
//! World::<Point<f32>, 4>::new().save(&mut bytes).unwrap(); // an empty world is a header
//! assert!(World::<Point<f32>, 4>::load(&bytes).unwrap().is_empty());
//! ```
//!
//! ```text
//!  0  4  "fixs"          16  4  number of bodies
//!  4  2  version         20  8  tick
//!  6  2  kind of body    28  8  next id
//!  8  4  number type     36  4  FNV-1a of all other bytes
//! 12  4  bytes a body    40  .  id and state of each body, in order
//! ```
//!
//! The bytes are little endian on every target. A body with its id takes, in bytes:
//!
//! | | [`Point`](crate::Point) | [`Carried`](crate::Carried) | [`Rigid`](crate::Rigid) point | `Rigid` carried point |
//! |---|---|---|---|---|
//! | 32-bit fixed point | 24 | 36 | 38 | 56 |
//! | `f32` | 24 | 36 | 37 | 55 |
//!
//! A *carried* point keeps what rounding loses. A [`RangeChecked`](crate::RangeChecked) body takes one byte more.
//!
//! The loaded world continues with the same bits, on any target that computes the same bits. Forces,
//! method and timestep are not saved: make them again, with the ids in [`World::ids`]. Within one program
//! a clone of the world does the same at less cost.
//!
//! A snapshot with one changed byte is always an error. Every byte enters the checksum by an
//! invertible step, so two inputs that differ in one byte have different checksums.

mod bodies;
mod bytes;
mod error;
mod range_checked;

use crate::body::Body;
use crate::body::id::BodyId;
use crate::scalar::Stored;
use crate::world::World;

pub use error::SnapshotError;

use crate::world::fnv::Fnv32;
use bytes::{Reader, Writer};

/// The version of the format that is written, and the only one that is read.
///
/// ```
/// use fixstep::{Point, World, world::snapshot::VERSION};
/// let mut bytes = [0; 40];
/// World::<Point<f32>, 0>::new().save(&mut bytes).unwrap();
/// assert_eq!(bytes[4..6], VERSION.to_le_bytes());
/// ```
pub const VERSION: u16 = 1;

/// Bytes before the first body.
///
/// ```
/// use fixstep::{Point, World, world::snapshot::HEADER};
/// assert_eq!(World::<Point<f32>, 8>::SNAPSHOT, HEADER + 8 * 24);
/// ```
pub const HEADER: usize = 40;

const MAGIC: [u8; 4] = *b"fixs";
/// The bytes of the checksum.
const SUM: core::ops::Range<usize> = 36..40;
/// Bytes of an id.
const ID: usize = 4;
/// The next id if all ids are used.
const NO_ID: u64 = 1 << 32;

/// A body that a snapshot can hold.
///
/// ```
/// use fixstep::{Point, Saved, vec2};
/// let ball = Point::<f32>::new(vec2(1, 2)?, vec2(3, 4)?, 2)?;
/// let mut words = Vec::new();
/// ball.save(&mut |word, bytes| words.push((word, bytes)));
/// assert_eq!(words.iter().map(|&(_, bytes)| bytes).sum::<usize>(), Point::<f32>::BYTES);
/// let mut words = words.into_iter();
/// assert_eq!(Point::load(&mut |_| words.next().unwrap().0), Some(ball));
/// # Ok::<(), fixstep::Error>(())
/// ```
pub trait Saved: Body<S: Stored> {
    /// The number of this kind of body. Use a number from `0x8000` to below `0xC000` for your own.
    ///
    /// A [`RangeChecked`](crate::RangeChecked) body sets the bit `0x4000`. A [`Rigid`](crate::Rigid) body
    /// has the number of its centre plus two.
    const KIND: u16;

    /// Bytes of its state: as many as `save` writes and `load` reads.
    const BYTES: usize;

    /// Passes its state to `write`, as words with the number of their lowest bytes to keep, at most 8.
    fn save(&self, write: &mut impl FnMut(u64, usize));

    /// Makes the body from the words of `read`, in the order of `save`. `None` if the state is invalid.
    #[must_use]
    fn load(read: &mut impl FnMut(usize) -> u64) -> Option<Self>;
}

impl<B: Saved, const N: usize> World<B, N> {
    /// Bytes of the snapshot of a full world.
    pub const SNAPSHOT: usize = HEADER + N * (ID + B::BYTES);

    /// Writes the world to the front of `bytes` and returns the number of bytes written: 40, and 24 for
    /// each [`Point`](crate::Point) of a 32-bit scalar. A slice that is too short is an error.
    ///
    /// ```
    /// use fixstep::{vec2, Point, World, fixed::types::I16F16};
    /// type Scene = World<Point<I16F16>, 8>;
    /// let mut world = Scene::new();
    /// world.add(Point::new(vec2(0, 2)?, vec2(3, 0)?, 1)?).unwrap();
    /// let mut bytes = [0; Scene::SNAPSHOT];
    /// let length = world.save(&mut bytes).unwrap();
    /// let again = Scene::load(&bytes[..length]).unwrap();
    /// assert_eq!(again.state_hash(), world.state_hash());
    /// assert!(World::<Point<f32>, 8>::load(&bytes[..length]).is_err());
    /// # Ok::<(), fixstep::Error>(())
    /// ```
    pub fn save(&self, bytes: &mut [u8]) -> Result<usize, SnapshotError> {
        let needed = HEADER + self.len() * (ID + B::BYTES);
        let given = bytes.len();
        let error = SnapshotError::Length { needed, given };
        let bytes = bytes.get_mut(..needed).ok_or(error)?;
        let mut out = Writer(bytes);
        MAGIC.iter().for_each(|&byte| out.put(byte as u64, 1));
        out.put(VERSION as u64, 2);
        out.put(B::KIND as u64, 2);
        out.put(B::S::FORMAT as u64, 4);
        out.put(B::BYTES as u64, 4);
        out.put(self.len() as u64, 4);
        out.put(self.tick(), 8);
        out.put(self.next_id().map_or(NO_ID, |id| id.serial() as u64), 8);
        out.put(0, SUM.len());
        for (id, body) in self.iter() {
            out.put(id.serial() as u64, ID);
            body.save(&mut |word, count| out.put(word, count));
        }
        let sum = checksum(bytes);
        Writer(bytes.get_mut(SUM).unwrap_or_default()).put(sum as u64, SUM.len());
        Ok(needed)
    }

    /// Loads a world that [`save`](World::save) wrote. It is an error if the version, number type, kind
    /// of body or length differ. Changed bytes and too many bodies are errors too.
    ///
    /// ```
    /// # use fixstep::{Point, World, vec2};
    /// let mut world = World::<Point<f32>, 2>::new();
    /// let id = world.add(Point::new(vec2(0, 2)?, vec2(3, 0)?, 1)?)?;
    /// let mut bytes = [0; 88];
    /// let length = world.save(&mut bytes).unwrap(); // 40 + 24
    /// let loaded = World::<Point<f32>, 2>::load(&bytes[..length]).unwrap();
    /// assert_eq!(loaded.get(id)?, world.get(id)?);
    /// # Ok::<(), fixstep::Error>(())
    /// ```
    pub fn load(bytes: &[u8]) -> Result<Self, SnapshotError> {
        let given = bytes.len();
        let length = |needed| SnapshotError::Length { needed, given };
        let (header, bodies) = bytes.split_at_checked(HEADER).ok_or(length(HEADER))?;
        let mut from = Reader(header);
        if MAGIC.iter().any(|&byte| from.take(1) != byte as u64) {
            return Err(SnapshotError::NotASnapshot);
        }
        let version = from.take(2) as u16;
        if version != VERSION {
            return Err(SnapshotError::Version(version));
        }
        if checksum(bytes) as u64 != Reader(bytes.get(SUM).unwrap_or_default()).take(SUM.len()) {
            return Err(SnapshotError::Checksum);
        }
        let (kind, format) = (from.take(2) as u16, from.take(4) as u32);
        if kind != B::KIND {
            return Err(SnapshotError::Kind(kind));
        }
        if format != B::S::FORMAT {
            return Err(SnapshotError::Scalar(format));
        }
        if from.take(4) != B::BYTES as u64 {
            return Err(SnapshotError::Kind(kind));
        }
        let count = from.take(4) as u32;
        let (tick, next) = (from.take(8), from.take(8));
        let needed = HEADER as u64 + count as u64 * (ID + B::BYTES) as u64;
        if needed != given as u64 {
            return Err(length(usize::try_from(needed).unwrap_or(usize::MAX)));
        }
        if count as usize > N {
            let (bodies, capacity) = (count, N);
            return Err(SnapshotError::Full { bodies, capacity });
        }
        Self::from_state(tick, next, count, &mut Reader(bodies)).ok_or(SnapshotError::State)
    }

    fn from_state(tick: u64, next: u64, count: u32, from: &mut Reader) -> Option<Self> {
        let mut world = World::new();
        for _ in 0..count {
            let id = BodyId::from_serial(from.take(ID) as u32);
            let body = B::load(&mut |count| from.take(count))?;
            world.put_back(id, body)?;
        }
        let next = match next {
            NO_ID => None,
            _ => Some(BodyId::from_serial(u32::try_from(next).ok()?)),
        };
        world.go_on_from(tick, next)?;
        Some(world)
    }
}

/// The checksum of all bytes except its own four.
fn checksum(bytes: &[u8]) -> u32 {
    let mut sum = Fnv32::new();
    for part in [bytes.get(..SUM.start), bytes.get(SUM.end..)] {
        part.unwrap_or_default()
            .iter()
            .for_each(|&byte| sum.write(byte));
    }
    sum.0
}
