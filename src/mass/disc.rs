//! A disc.
//!
//! ```text
//! A = π r²
//! I / m = r² / 2          ∫ ρ² 2πρ dρ from 0 to r, over A
//! ```

use super::{PI, Shape, positive};
use crate::error::Error;
use crate::ratio::Ratio;
use crate::scalar::Scalar;

/// A disc with its centre at the origin. `radius` is in m and must be positive.
///
/// ```
/// use fixstep::{dec, mass::disc};
/// let puck = disc::<f32>(dec!(0.04))?.with_mass(dec!(0.16))?;
/// assert_eq!(puck.inertia(), dec!(0.000128));
/// # Ok::<(), fixstep::Error>(())
/// ```
pub fn disc<S: Scalar>(radius: impl Into<Ratio>) -> Result<Shape<S>, Error> {
    let radius = positive("radius", radius.into())?;
    let measures = || {
        let square = radius.square()?;
        Some([PI.times(square)?, square.per(2.into())?])
    };
    Shape::about_origin(("radius", radius), measures())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dec;

    #[test]
    fn is_half_its_square() {
        let half = disc::<f32>(dec!(0.5)).unwrap();
        assert_eq!(half.inertia_per_mass(), dec!(0.125));
        assert!((half.area().to_f64() - core::f64::consts::FRAC_PI_4).abs() <= 1e-16);
        assert!(disc::<f32>(0).is_err());
    }
}
