//! Logging with defmt: what a firmware prints while it is being made.

use defmt::{Format, Formatter, write};

use crate::body::id::{BodyId, Stale};
use crate::body::{Body, Carried, Point, RangeChecked};
use crate::error::{Error, Full};
use crate::ratio::Ratio;
use crate::rigid::{Angle, Centre, Rigid};
use crate::scalar::{Angular, Carry, Scalar, Turns};
use crate::time::Due;
use crate::vec2::Vec2;
use crate::world::World;
use crate::world::rewind::RewindError;
use crate::world::snapshot::{SnapshotError, VERSION};

impl<S: Format> Format for Vec2<S> {
    fn format(&self, f: Formatter) {
        write!(f, "({}, {})", self.x, self.y);
    }
}

impl Format for BodyId {
    fn format(&self, f: Formatter) {
        write!(f, "body {=u32}", self.serial());
    }
}

impl<S: Scalar + Format> Format for Point<S> {
    fn format(&self, f: Formatter) {
        write!(f, "at {} with {}", self.position(), self.velocity());
    }
}

impl<S: Carry + Format> Format for Carried<S> {
    fn format(&self, f: Formatter) {
        write!(f, "at {} with {}", self.position(), self.velocity());
    }
}

/// As a number of turns in the scalar, from -1/2 to 1/2: its 32 highest bits.
impl<S: Angular + Format> Format for Angle<S> {
    fn format(&self, f: Formatter) {
        let bits = self.count().bits() << (64 - 8 * size_of::<S::Turns>().min(8));
        let turns = Ratio::new((bits as i64) >> 32, 1 << 32).ok();
        write!(f, "{} turns", turns.and_then(S::ratio).unwrap_or(S::ZERO));
    }
}

impl<C: Centre<S: Format> + Format> Format for Rigid<C> {
    fn format(&self, f: Formatter) {
        let (driven, centre, _) = self.parts();
        let (angle, spin) = (self.angle(), self.spin());
        write!(f, "{}, at {}, {} turns/s", centre, angle, spin);
        if driven {
            write!(f, ", driven");
        }
    }
}

impl<B: Body + Format> Format for RangeChecked<B> {
    fn format(&self, f: Formatter) {
        write!(f, "{}", self.body());
        if self.was_outside() {
            write!(f, ", was outside");
        }
    }
}

impl<B: Body + Format, const N: usize> Format for World<B, N> {
    fn format(&self, f: Formatter) {
        write!(f, "tick {=u64}: {=[?]}", self.tick(), self.bodies());
    }
}

impl Format for Ratio {
    fn format(&self, f: Formatter) {
        match self.den() {
            1 => write!(f, "{=i64}", self.num()),
            den => write!(f, "{=i64}/{=u64}", self.num(), den),
        }
    }
}

impl Format for Due {
    fn format(&self, f: Formatter) {
        write!(f, "{=u32} steps, {=u64} dropped", self.steps, self.dropped);
    }
}

impl Format for Error {
    fn format(&self, f: Formatter) {
        match *self {
            Error::Empty { field } => write!(f, "{=str} must not be empty", field),
            Error::NotPositive { field, value } => {
                write!(f, "{=str} must be greater than zero, not {}", field, value)
            }
            Error::Negative { field, value } => {
                write!(f, "{=str} must not be negative, not {}", field, value)
            }
            Error::OutOfRange { field, value } => {
                write!(f, "{=str} {} is out of range", field, value)
            }
            Error::RoundsToZero { field, value } => {
                write!(f, "{=str} {} is too small to be held", field, value)
            }
            Error::Full { capacity } => {
                write!(
                    f,
                    "a world for {=usize} bodies has no room for another",
                    capacity
                )
            }
            Error::Stale { serial } => write!(f, "body {=u32} is not in the world", serial),
            Error::NotFinite { field } => {
                write!(f, "{=str} is NaN, infinite or too large", field)
            }
            Error::NotANumber { field } => {
                write!(f, "{=str} is not a number, or has too many digits", field)
            }
            Error::Degenerate { shape } => write!(f, "the {=str} has no area", shape),
            Error::NotConvex { vertex } => {
                write!(f, "the outline is not convex at vertex {=usize}", vertex)
            }
        }
    }
}

impl<B> Format for Full<B> {
    fn format(&self, f: Formatter) {
        Error::from(self).format(f);
    }
}

impl Format for Stale {
    fn format(&self, f: Formatter) {
        Error::from(*self).format(f);
    }
}

impl Format for SnapshotError {
    fn format(&self, f: Formatter) {
        use SnapshotError::*;
        match *self {
            Length { needed, given } => {
                write!(
                    f,
                    "a snapshot of {=usize} bytes does not fit {=usize}",
                    needed, given
                )
            }
            NotASnapshot => write!(f, "these bytes are no snapshot"),
            Version(version) => write!(
                f,
                "snapshot has version {=u16}, this reads {=u16}",
                version, VERSION
            ),
            Checksum => write!(f, "snapshot was damaged: its checksum is wrong"),
            Kind(kind) => write!(f, "snapshot has bodies of another kind: {=u16}", kind),
            Scalar(format) => write!(f, "snapshot has another number type: {=u32:#010x}", format),
            Full { bodies, capacity } => write!(
                f,
                "snapshot has {=u32} bodies, the world holds {=usize}",
                bodies, capacity
            ),
            State => write!(f, "snapshot has a state that no world can have"),
        }
    }
}

impl Format for RewindError {
    fn format(&self, f: Formatter) {
        match *self {
            RewindError::AtStart => write!(f, "a world at tick 0 has no step to undo"),
            RewindError::Saturated { body } => {
                write!(f, "{} left the range: its steps cannot be undone", body)
            }
            RewindError::Damped { force } => {
                write!(f, "{=str} has damping: its steps cannot be undone", force)
            }
        }
    }
}
