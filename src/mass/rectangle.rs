//! A rectangle.
//!
//! ```text
//! A = w h
//! I / m = (w² + h²) / 12      ∫ x² dx from -w/2 to w/2, over w, and the same for h
//! ```

use super::{Shape, longer, positive};
use crate::error::Error;
use crate::ratio::Ratio;
use crate::scalar::Scalar;

/// A rectangle with its centre at the origin. `width` and `height` are in m and must be positive.
///
/// ```
/// use fixstep::{dec, mass::rectangle};
/// let crate_of_tea = rectangle::<f32>(dec!(0.6), dec!(0.8))?.with_mass(36)?;
/// assert_eq!(crate_of_tea.inertia(), dec!(3));
/// # Ok::<(), fixstep::Error>(())
/// ```
pub fn rectangle<S: Scalar>(
    width: impl Into<Ratio>,
    height: impl Into<Ratio>,
) -> Result<Shape<S>, Error> {
    let width = positive("width", width.into())?;
    let height = positive("height", height.into())?;
    let measures = || {
        let squares = width.square()?.and(height.square()?)?;
        Some([width.times(height)?, squares.per(12.into())?])
    };
    Shape::about_origin(longer(("width", width), ("height", height)), measures())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dec;

    #[test]
    fn is_a_twelfth_of_its_diagonal_squared() {
        let card = rectangle::<f32>(3, 4).unwrap();
        assert_eq!(
            (card.area(), card.inertia_per_mass()),
            (dec!(12), Ratio::new(25, 12).unwrap())
        );
        assert!(rectangle::<f32>(3, 0).is_err());
    }
}
