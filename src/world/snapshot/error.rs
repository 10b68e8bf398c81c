//! Why bytes were not written or not read.

use core::fmt;

use super::VERSION;

/// Why bytes were not written or not read. The call that returns it changes nothing.
///
/// ```
/// use fixstep::{Point, SnapshotError, World};
/// let result = World::<Point<f32>, 2>::load(&[0; 40]);
/// assert_eq!(result.unwrap_err(), SnapshotError::NotASnapshot);
/// let result = World::<Point<f32>, 2>::new().save(&mut [0; 8]);
/// assert_eq!(result, Err(SnapshotError::Length { needed: 40, given: 8 }));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SnapshotError {
    /// The slice has fewer or more bytes than the snapshot.
    Length {
        /// Bytes of the snapshot, as far as known.
        needed: usize,
        /// Bytes of the slice.
        given: usize,
    },
    /// The bytes do not begin with `fixs`.
    NotASnapshot,
    /// The snapshot has another version of the format.
    Version(u16),
    /// The checksum is wrong: bytes were changed.
    Checksum,
    /// The snapshot has another kind of body, or one with another number of bytes.
    Kind(u16),
    /// The snapshot has another number type.
    Scalar(u32),
    /// The snapshot has more bodies than the world can hold.
    Full {
        /// Bodies in the snapshot.
        bodies: u32,
        /// Bodies that the world can hold.
        capacity: usize,
    },
    /// The state is invalid: ids do not rise, or a mass, an inertia or a remainder is not allowed.
    State,
}

impl fmt::Display for SnapshotError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length { needed, given } => {
                write!(
                    f,
                    "length {given} bytes is out of range: the snapshot has {needed} bytes"
                )
            }
            Self::NotASnapshot => {
                f.write_str("bytes 0 to 3 are not \"fixs\": this is not a snapshot")
            }
            Self::Version(version) => {
                write!(
                    f,
                    "version {version} is out of range: only {VERSION} is allowed"
                )
            }
            Self::Checksum => f.write_str("checksum is wrong: bytes of the snapshot were changed"),
            Self::Kind(kind) => write!(f, "kind of body {kind:#06x} does not match the world"),
            Self::Scalar(format) => {
                write!(f, "number type {format:#010x} does not match the world")
            }
            Self::Full { bodies, capacity } => {
                write!(
                    f,
                    "number of bodies {bodies} is out of range: at most {capacity}"
                )
            }
            Self::State => f.write_str(
                "state is invalid: an id, a mass, an inertia or a remainder is not allowed",
            ),
        }
    }
}

impl core::error::Error for SnapshotError {}
