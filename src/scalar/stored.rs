//! Numbers as bits, for snapshots.

use fixed::types::extra::{LeEqU32, LeEqU64};
use fixed::{FixedI32, FixedI64};

use super::factor::{Coef, InvMass};

/// A number that a snapshot can hold. To save worlds of your own number type, implement it for that
/// type and its inverse mass. For bodies that rotate, implement it for its coefficients too.
///
/// ```
/// use fixstep::{Stored, fixed::types::I16F16};
/// let x = I16F16::lit("-1.5");
/// assert_eq!(x.store(), 0xFFFE_8000);
/// assert_eq!(I16F16::restore(0xFFFE_8000), Some(x));
/// assert_eq!(I16F16::restore(1 << 32), None);
/// ```
pub trait Stored: Copy {
    /// Identifies the number type. Values for your own types start at `0x8000_0000`.
    const FORMAT: u32;

    /// Bytes it takes, 8 at most.
    const BYTES: usize;

    /// Its exact bits, in the lowest [`BYTES`](Stored::BYTES) bytes: NaN and -0 as they are.
    #[must_use]
    fn store(self) -> u64;

    /// The number that has these bits; `None` where no number has them.
    #[must_use]
    fn restore(bits: u64) -> Option<Self>;
}

macro_rules! float {
    ($float:ident, $bits:ident) => {
        impl Stored for $float {
            const FORMAT: u32 = 0x0200_0000 | $bits::BITS;
            const BYTES: usize = size_of::<$float>();

            fn store(self) -> u64 {
                self.to_bits().into()
            }

            fn restore(bits: u64) -> Option<$float> {
                Some($float::from_bits($bits::try_from(bits).ok()?))
            }
        }
    };
}

float!(f32, u32);
float!(f64, u64);

macro_rules! fixed_point {
    ($fixed:ident<$bound:ident>, $raw:ident, $unsigned:ident) => {
        impl<F: $bound> Stored for $fixed<F> {
            const FORMAT: u32 = 0x0100_0000 | $raw::BITS << 8 | F::U32;
            const BYTES: usize = size_of::<$raw>();

            fn store(self) -> u64 {
                (self.to_bits() as $unsigned).into()
            }

            fn restore(bits: u64) -> Option<Self> {
                Some($fixed::from_bits($unsigned::try_from(bits).ok()? as $raw))
            }
        }

        impl Stored for InvMass<$raw> {
            const FORMAT: u32 = 0x0300_0000 | $raw::BITS;
            const BYTES: usize = size_of::<$raw>();

            fn store(self) -> u64 {
                (self.0 as $unsigned).into()
            }

            // A mantissa has its highest bit set, or a division by it would lose bits.
            fn restore(bits: u64) -> Option<Self> {
                let bits = $unsigned::try_from(bits).ok()?;
                (bits >> ($raw::BITS - 2) == 1).then_some(InvMass(bits as $raw))
            }
        }
    };
}

fixed_point!(FixedI32<LeEqU32>, i32, u32);
fixed_point!(FixedI64<LeEqU64>, i64, u64);

/// Reads only what `new` makes from a fraction: a mantissa of the full number of bits, or zero.
impl Stored for Coef<i32> {
    const FORMAT: u32 = 0x0400_0000 | i32::BITS;
    const BYTES: usize = 5;

    fn store(self) -> u64 {
        let (mantissa, shift) = self.parts();
        (shift as u64) << 32 | mantissa as u32 as u64
    }

    fn restore(bits: u64) -> Option<Self> {
        let (mantissa, shift) = (bits as i32, u32::try_from(bits >> 32).ok()?);
        let whole = mantissa == 0 || mantissa.unsigned_abs() >> (i32::BITS - 2) == 1;
        (whole && (1..=Self::MAX_SHIFT).contains(&shift)).then(|| Coef::from_raw(mantissa, shift))
    }
}
