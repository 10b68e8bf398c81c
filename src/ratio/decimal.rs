//! Decimals as ratios. The compiler reads literals.

use super::{Ratio, RatioError};

impl Ratio {
    /// Reads a decimal such as `-9.81`, `1_000` or `.5`: up to 18 digits, no exponent.
    /// The [`dec!`](crate::dec) macro calls it at compile time.
    pub const fn parse(text: &str) -> Result<Ratio, RatioError> {
        let error = Err(RatioError::NotANumber { field: "decimal" });
        let (bytes, mut i) = (text.as_bytes(), 0);
        let (mut num, mut den, mut digits) = (0_i64, 1_u64, 0);
        let (mut minus, mut point) = (false, false);
        while i < bytes.len() {
            match bytes[i] {
                b'-' if digits == 0 && !minus && !point => minus = true,
                b'.' if !point => point = true,
                b'_' if digits > 0 => {}
                b' ' if digits == 0 && !point => {}
                b @ b'0'..=b'9' if digits < 18 => {
                    num = num * 10 + (b - b'0') as i64;
                    digits += 1;
                    if point {
                        den *= 10;
                    }
                }
                _ => return error,
            }
            i += 1;
        }
        if digits == 0 {
            return error;
        }
        Ratio::new(if minus { -num } else { num }, den)
    }
}

/// A decimal literal as an exact [`Ratio`], read at compile time.
///
/// ```
/// use fixstep::{dec, Ratio};
/// const G: Ratio = dec!(9.81);
/// assert_eq!(G.num(), 981);
/// ```
///
/// Anything but a plain decimal does not compile:
///
/// ```compile_fail
/// let x = fixstep::dec!(1e9);
/// ```
#[macro_export]
macro_rules! dec {
    ($literal:expr) => {{
        const RATIO: $crate::Ratio = match $crate::Ratio::parse(stringify!($literal)) {
            Ok(ratio) => ratio,
            Err(_) => panic!("not a plain decimal"),
        };
        RATIO
    }};
}
