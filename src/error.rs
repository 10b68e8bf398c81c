//! The errors of the crate, and a table of every input that a call refuses.
//!
//! Nothing panics. A call that returns an error changes nothing. A step returns no error: it saturates, and
//! [`World::out_of_range`](crate::World::out_of_range) tests for it. Each row of this table has a test.
//!
//! | input | where | error | what is kept |
//! |---|---|---|---|
//! | a mass of zero or less | [`Point::new`](crate::Point::new) | `NotPositive` | no body was made |
//! | a mass whose inverse the scalar cannot hold | [`Point::new`](crate::Point::new) | `OutOfRange` | no body was made |
//! | NaN or infinity as a number | [`Ratio::from_f64`](crate::Ratio::from_f64) | `NotFinite` | no number was made |
//! | a fraction over zero, or of more than 62 bits | [`Ratio::new`](crate::Ratio::new) | `NotANumber` | no number was made |
//! | a text that is no plain decimal | [`Ratio::parse`](crate::Ratio::parse); `dec!` does not compile | `NotANumber` | no number was made |
//! | a component outside of the scalar | [`vec2`](crate::vec2()) | `OutOfRange` | no vector was made |
//! | NaN or infinity as position or velocity | [`Point`](crate::Point): `new`, `teleport`, `set_velocity` | `NotFinite` | the state it had |
//! | a rate of zero or less | [`Step::hz`](crate::Step::hz) | `NotPositive` | no step was made |
//! | a step of a quarter second or more, or too short | [`Step`](crate::Step): `hz`, `from_seconds` | `OutOfRange` | no step was made |
//! | a coefficient below zero | every force | `Negative` | no force was made |
//! | a coefficient that is too large, or a softening too small for it | every force | `OutOfRange` | no force was made |
//! | a coefficient or softening that would be zero, but is not | every force | `RoundsToZero` | no force was made |
//! | a length or acceleration outside of the scalar | [`Spring`](crate::Spring), [`Pull`](crate::Pull), [`GravityY`](crate::GravityY) | `OutOfRange` | no force was made |
//! | a softening of zero or less | [`Pull::new`](crate::Pull::new) | `NotPositive` | no force was made |
//! | a frequency of zero or less | [`ExactSpring`](crate::ExactSpring), [`ExactPair`](crate::ExactPair) | `NotPositive` | no force was made |
//! | a damping ratio below zero | [`ExactSpring`](crate::ExactSpring), [`ExactPair`](crate::ExactPair) | `Negative` | no force was made |
//! | a frequency below `2^-20` Hz or from `2^20` Hz, or a damping ratio from `2^10` | [`ExactSpring`](crate::ExactSpring), [`ExactPair`](crate::ExactPair) | `OutOfRange` | no force was made |
//! | a sag outside of the scalar, or from its point to there | [`ExactSpring::with_gravity`](crate::ExactSpring::with_gravity) | `OutOfRange` | no force was made |
//! | no point masses | [`CentreOfMass::new`](crate::CentreOfMass::new) | `Empty` | nothing was made |
//! | a point mass of zero or less | [`CentreOfMass::new`](crate::CentreOfMass::new) | `NotPositive` | nothing was made |
//! | a point mass that is NaN or infinite | [`CentreOfMass::new`](crate::CentreOfMass::new) | `NotFinite` | nothing was made |
//! | a total mass that no fraction of 62 bits, or no body, can hold | [`CentreOfMass`](crate::CentreOfMass): `new`, `point` | `OutOfRange` | nothing was made |
//! | a radius, width or height of zero or less | [`disc`](crate::mass::disc()), [`ring`](crate::mass::ring()), [`rectangle`](crate::mass::rectangle()), [`capsule`](crate::mass::capsule()) | `NotPositive` | no shape was made |
//! | an inner radius or a length below zero | [`ring`](crate::mass::ring()), [`capsule`](crate::mass::capsule()) | `Negative` | no shape was made |
//! | an inner radius above the outer | [`ring`](crate::mass::ring()) | `OutOfRange` | no shape was made |
//! | a shape too large for 62 bits of square metres | [`disc`](crate::mass::disc()), [`ring`](crate::mass::ring()), [`rectangle`](crate::mass::rectangle()), [`capsule`](crate::mass::capsule()) | `OutOfRange` | no shape was made |
//! | a shape too small for them | [`disc`](crate::mass::disc()), [`ring`](crate::mass::ring()), [`rectangle`](crate::mass::rectangle()), [`capsule`](crate::mass::capsule()) | `RoundsToZero` | no shape was made |
//! | no vertices | [`polygon`](crate::mass::polygon()), [`convex_polygon`](crate::mass::convex_polygon()) | `Empty` | no shape was made |
//! | a vertex that is NaN or infinite, or too many square metres for 62 bits | [`polygon`](crate::mass::polygon()), [`convex_polygon`](crate::mass::convex_polygon()) | `NotFinite` | no shape was made |
//! | a polygon without area: on one line, of two vertices, in two lobes alike | [`polygon`](crate::mass::polygon()), [`convex_polygon`](crate::mass::convex_polygon()) | `Degenerate` | no shape was made |
//! | a corner that is straight or turns the other way, or a second turn | [`convex_polygon`](crate::mass::convex_polygon()) | `NotConvex` | no shape was made |
//! | a shape's mass or density of zero or less, or a density where it has no area | [`Shape`](crate::Shape): `with_mass`, `with_density` | `NotPositive` | nothing was made |
//! | a shape's mass that 62 bits cannot hold | [`Shape`](crate::Shape): `with_mass`, `with_density` | `OutOfRange` | nothing was made |
//! | a shape's mass of so little inertia that it would be zero | [`Shape`](crate::Shape): `with_mass`, `with_density` | `RoundsToZero` | nothing was made |
//! | mass properties of no mass or less | [`MassProperties::new`](crate::MassProperties::new) | `NotPositive` | nothing was made |
//! | a moment of inertia below zero | [`MassProperties::new`](crate::MassProperties::new) | `Negative` | nothing was made |
//! | a part that is moved out of the range, or a point that is NaN | [`MassProperties`](crate::MassProperties): `new`, `at`, `inertia_about` | `NotFinite` | nothing was made |
//! | no parts | [`MassProperties`](crate::MassProperties): `from_parts`, `from_points` | `Empty` | nothing was made |
//! | parts whose sums 62 bits cannot hold | [`MassProperties`](crate::MassProperties): `from_parts`, `from_points`, `without` | `NotFinite` | nothing was made |
//! | a hole that takes more mass or inertia than there is | [`MassProperties::without`](crate::MassProperties::without) | `OutOfRange` | nothing was made |
//! | an inertia of zero or less | [`Rigid::new`](crate::Rigid::new) | `NotPositive` | no body was made |
//! | an inertia whose inverse the scalar cannot hold | [`Rigid::new`](crate::Rigid::new) | `OutOfRange` | no body was made |
//! | a spin outside of the scalar | [`Rigid::with_spin`](crate::Rigid::with_spin) | `OutOfRange` | no body was made |
//! | NaN or infinity as state of a body that turns | [`Rigid`](crate::Rigid): `kinematic`, `static_at`, `teleport`, `set_velocity`, `set_spin` | `NotFinite` | the state it had |
//! | a drag against spin below zero | [`SpinDrag::new`](crate::rigid::torque::SpinDrag::new) | `Negative` | no force was made |
//! | a clock that stands still, or no steps a frame | [`Accumulator::new`](crate::Accumulator::new) | `NotPositive` | nothing was made |
//! | a clock and a step without a common unit | [`Accumulator::new`](crate::Accumulator::new) | `OutOfRange` | nothing was made |
//! | a part of a step below 0 or above 1 | [`Between::new`](crate::Between::new) | `OutOfRange` | nothing was made |
//! | a body for a full world, or one that has given `2^32` ids | [`World::add`](crate::World::add) | `Full` | the world; the body comes back |
//! | a stale id | [`World`](crate::World): `get`, `get_mut`, `remove`, `index_of` | `Stale` | the world |
//! | a stale id in a force | any step | none: the force waits | the other forces act |
//! | a scene that leaves the range | any step | none: fixed point saturates, floats become infinite | `out_of_range` names the bodies |
//! | NaN in a vector or from a function that a force was given | any step | none: it spreads to the body | `out_of_range` names the body |
//! | fewer places in `AllBodies` than bodies | any step | none: the others feel nothing | the bodies it has places for |
//! | a slice too short for a snapshot | [`World::save`](crate::World::save) | `Length` | the slice |
//! | a cut header, or another count than the bytes hold | [`World::load`](crate::World::load) | `Length` | nothing was made |
//! | bytes that are no snapshot | [`World::load`](crate::World::load) | `NotASnapshot` | nothing was made |
//! | a snapshot of another version | [`World::load`](crate::World::load) | `Version` | nothing was made |
//! | a snapshot with a changed bit, or cut behind its header | [`World::load`](crate::World::load) | `Checksum` | nothing was made |
//! | a snapshot of another kind of body | [`World::load`](crate::World::load) | `Kind` | nothing was made |
//! | a snapshot of another number type | [`World::load`](crate::World::load) | `Scalar` | nothing was made |
//! | a snapshot of more bodies than there is room | [`World::load`](crate::World::load) | `Full` | nothing was made |
//! | a snapshot whose ids do not rise, or of no mass or inertia | [`World::load`](crate::World::load) | `State` | nothing was made |
//! | to go back from tick 0 | [`World::step_back`](crate::World::step_back) | `AtStart` | the world |
//! | to go back with a body that has left the range, or would on the way | [`World::step_back`](crate::World::step_back) | `Saturated` | the world |
//! | to undo a step in which a force has damping | [`World::step_back`](crate::World::step_back) | `Damped` | the world |
//!
//! ```
//! use fixstep::{Error, Step, fixed::types::I16F16};
//! assert!(matches!(Step::<I16F16>::hz(0), Err(Error::NotPositive { .. })));
//! ```

use core::fmt;

use crate::ratio::{Ratio, RatioError};

/// Why a value was refused. The call that returns it changes nothing.
///
/// ```
/// use fixstep::{Error, fixed::types::I16F16, vec2};
/// let error = vec2::<I16F16>(40_000, 0).unwrap_err();
/// assert!(matches!(error, Error::OutOfRange { field: "x", .. }));
/// assert_eq!(error.to_string(), "x 40000 is out of range");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Error {
    /// The list must have at least one element.
    Empty {
        /// Name of the argument.
        field: &'static str,
    },
    /// The field must be greater than zero.
    NotPositive {
        /// Name of the argument.
        field: &'static str,
        /// Its value.
        value: Ratio,
    },
    /// The field must not be less than zero.
    Negative {
        /// Name of the argument.
        field: &'static str,
        /// Its value.
        value: Ratio,
    },
    /// The value is outside the range of the field, or of the number type that has to hold it.
    OutOfRange {
        /// Name of the argument.
        field: &'static str,
        /// Its value.
        value: Ratio,
    },
    /// The value is not zero, but the number type, or its coefficient, would round it to zero.
    RoundsToZero {
        /// Name of the argument.
        field: &'static str,
        /// Its value.
        value: Ratio,
    },
    /// The world has no room for another body.
    Full {
        /// How many the world holds.
        capacity: usize,
    },
    /// The body is not, or no longer, in the world.
    Stale {
        /// Its serial number.
        serial: u32,
    },
    /// NaN, infinite, or too large for any number type.
    NotFinite {
        /// Name of the argument.
        field: &'static str,
    },
    /// A fraction with denominator zero or more than 62 bits, or a decimal that cannot be read.
    NotANumber {
        /// Name of the argument.
        field: &'static str,
    },
    /// The shape has no area, or one too small for 62 bits.
    Degenerate {
        /// Name of the shape.
        shape: &'static str,
    },
    /// The corner is straight or bends the other way, or the outline goes round more than once.
    NotConvex {
        /// Which vertex, from 0.
        vertex: usize,
    },
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::Empty { field } => write!(f, "{field} must not be empty"),
            Error::NotPositive { field, value } => {
                write!(f, "{field} must be greater than zero, not {value}")
            }
            Error::Negative { field, value } => {
                write!(f, "{field} must not be negative, not {value}")
            }
            Error::OutOfRange { field, value } => {
                write!(f, "{field} {value} is out of range")
            }
            Error::RoundsToZero { field, value } => {
                write!(f, "{field} {value} is too small: it would round to zero")
            }
            Error::Full { capacity } => {
                write!(f, "a world for {capacity} bodies has no room for another")
            }
            Error::Stale { serial } => write!(f, "body {serial} is not in the world"),
            Error::NotFinite { field } => RatioError::NotFinite { field }.fmt(f),
            Error::NotANumber { field } => RatioError::NotANumber { field }.fmt(f),
            Error::Degenerate { shape } => write!(f, "the {shape} has no area"),
            Error::NotConvex { vertex } => {
                write!(f, "the outline is not convex at vertex {vertex}")
            }
        }
    }
}

impl core::error::Error for Error {}

impl From<RatioError> for Error {
    fn from(error: RatioError) -> Error {
        match error {
            RatioError::NotFinite { field } => Error::NotFinite { field },
            RatioError::NotANumber { field } => Error::NotANumber { field },
        }
    }
}

/// The world has no room, or has given all its `2^32` ids. The body that was to be added is inside.
/// `?` converts it to an [`Error`], without the body.
///
/// ```
/// use fixstep::{Error, Point, World, dec, fixed::types::I16F16, vec2};
/// let ball = Point::<I16F16>::new(vec2(0, 2)?, vec2(1, 0)?, dec!(1))?;
/// let full = World::<_, 0>::new().add(ball).unwrap_err();
/// assert_eq!((full.body, full.capacity), (ball, 0));
/// assert_eq!(Error::from(full), Error::Full { capacity: 0 });
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Full<B> {
    /// The body that was not added.
    pub body: B,
    /// How many the world holds.
    pub capacity: usize,
}

impl<B> Full<B> {
    pub(crate) fn new(body: B, capacity: usize) -> Full<B> {
        Full { body, capacity }
    }
}

impl<B> fmt::Display for Full<B> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Error::from(self).fmt(f)
    }
}

impl<B: fmt::Debug> core::error::Error for Full<B> {}

impl<B> From<&Full<B>> for Error {
    fn from(full: &Full<B>) -> Error {
        let capacity = full.capacity;
        Error::Full { capacity }
    }
}

impl<B> From<Full<B>> for Error {
    fn from(full: Full<B>) -> Error {
        Error::from(&full)
    }
}
