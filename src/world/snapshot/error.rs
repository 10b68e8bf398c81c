//! Why bytes were not written or not read.

use core::fmt;

use super::VERSION;

/// Why bytes were not written or not read. Nothing is changed by the call that returns it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SnapshotError {
    /// There are fewer or more bytes than the snapshot has.
    Length {
        /// Bytes that it has, as far as is known.
        needed: usize,
        /// Bytes there are.
        given: usize,
    },
    /// The bytes do not begin as a snapshot does.
    NotASnapshot,
    /// It is of another version of the format.
    Version(u16),
    /// Bytes were changed.
    Checksum,
    /// It holds another kind of body, or one whose state takes another number of bytes.
    Kind(u16),
    /// It holds another number type.
    Scalar(u32),
    /// It holds more bodies than the world can.
    Full {
        /// Bodies that it holds.
        bodies: u32,
        /// Bodies that the world holds.
        capacity: usize,
    },
    /// No world has this state: ids that do not rise, a mass, an inertia or a remainder that is none.
    State,
}

impl fmt::Display for SnapshotError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length { needed, given } => {
                write!(f, "a snapshot of {needed} bytes does not fit {given}")
            }
            Self::NotASnapshot => f.write_str("these bytes are no snapshot"),
            Self::Version(version) => {
                write!(f, "snapshot has version {version}, this reads {VERSION}")
            }
            Self::Checksum => f.write_str("snapshot was damaged: its checksum is wrong"),
            Self::Kind(kind) => write!(f, "snapshot has bodies of another kind: {kind}"),
            Self::Scalar(format) => {
                write!(f, "snapshot has another number type: {format:#010x}")
            }
            Self::Full { bodies, capacity } => {
                write!(
                    f,
                    "snapshot has {bodies} bodies, the world holds {capacity}"
                )
            }
            Self::State => f.write_str("snapshot has a state that no world can have"),
        }
    }
}

impl core::error::Error for SnapshotError {}
