//! Why a number cannot be a [`Ratio`](super::Ratio).

use core::fmt;

/// Why a number was refused. `?` converts it to an [`Error`](crate::Error).
///
/// ```
/// use fixstep::{Error, Ratio};
/// fn half(of: i64) -> Result<Ratio, Error> {
///     Ok(Ratio::new(of, 2)?)
/// }
/// assert_eq!(half(i64::MAX), Err(Error::NotANumber { field: "ratio" }));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum RatioError {
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

impl fmt::Display for RatioError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RatioError::NotFinite { field } => {
                write!(f, "{field} is NaN, infinite or too large")
            }
            RatioError::NotANumber { field } => {
                write!(f, "{field} is not a number, or has too many digits")
            }
        }
    }
}

impl core::error::Error for RatioError {}
