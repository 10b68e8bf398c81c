//! A ring: a disc with a smaller disc cut out at the same centre.
//!
//! ```text
//! A = π (R² - r²)
//! I / m = (R⁴ - r⁴) / 2 / (R² - r²) = (R² + r²) / 2
//! ```
//!
//! The last form also holds for a hoop (`r = R`), which has a mass but no area.

use super::{PI, Shape, not_negative, positive};
use crate::error::Error;
use crate::ratio::Ratio;
use crate::scalar::Scalar;

/// A ring with its centre at the origin; radii in m. The outer radius must be positive, and the inner one
/// from zero to the outer. If both are equal it is a hoop, which has no area.
///
/// ```
/// use fixstep::{dec, mass::ring};
/// let tyre = ring::<f32>(dec!(0.3), dec!(0.2))?.with_mass(8)?;
/// let hoop = ring::<f32>(1, 1)?;
/// assert_eq!((tyre.inertia(), hoop.inertia_per_mass()), (dec!(0.52), dec!(1)));
/// assert!(hoop.with_density(1).is_err());
/// # Ok::<(), fixstep::Error>(())
/// ```
pub fn ring<S: Scalar>(
    outer: impl Into<Ratio>,
    inner: impl Into<Ratio>,
) -> Result<Shape<S>, Error> {
    let outer = positive("outer", outer.into())?;
    let (field, value) = ("inner", not_negative("inner", inner.into())?);
    if value.num() as i128 * outer.den() as i128 > outer.num() as i128 * value.den() as i128 {
        return Err(Error::OutOfRange { field, value });
    }
    let measures = || {
        let [large, small] = [outer.square()?, value.square()?];
        let area = PI.times(large.less(small)?)?;
        Some([area, large.and(small)?.per(2.into())?])
    };
    Shape::about_origin(("outer", outer), measures())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dec;

    #[test]
    fn goes_from_disc_to_hoop() {
        let per_mass = |inner: Ratio| ring::<f32>(2, inner).unwrap().inertia_per_mass();
        assert_eq!(per_mass(dec!(0)), dec!(2));
        assert_eq!(per_mass(dec!(1)), dec!(2.5));
        assert_eq!(per_mass(dec!(2)), dec!(4));
        assert_eq!(ring::<f32>(2, 2).unwrap().area(), Ratio::ZERO);
        assert!(ring::<f32>(2, dec!(2.1)).is_err());
    }
}
