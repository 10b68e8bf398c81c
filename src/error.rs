//! What a constructor says when it refuses a value, and what a full world hands back.

use core::fmt;

use crate::ratio::Ratio;

/// Why a value was refused. Nothing is changed by the call that returns it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Error {
    /// There must be at least one.
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
    /// The value is outside what the field, or the number type that has to hold it, can take.
    OutOfRange {
        /// Name of the argument.
        field: &'static str,
        /// Its value.
        value: Ratio,
    },
    /// The value is not zero, but the number type would make it zero.
    RoundsToZero {
        /// Name of the argument.
        field: &'static str,
        /// Its value.
        value: Ratio,
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
                write!(f, "{field} {value} is too small to be told from zero")
            }
            Error::NotFinite { field } => write!(f, "{field} is NaN, infinite or too large"),
            Error::NotANumber { field } => {
                write!(f, "{field} is not a number, or has too many digits")
            }
        }
    }
}

impl core::error::Error for Error {}

/// There was no room; the body that was to be added is inside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Full<B> {
    /// The body that found no place.
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
        write!(
            f,
            "a world for {} bodies has no room for another",
            self.capacity
        )
    }
}

impl<B: fmt::Debug> core::error::Error for Full<B> {}
