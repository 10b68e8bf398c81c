//! A capsule: a rectangle with half a disc at each end.
//!
//! ```text
//! A = 2 r L + π r²
//! I / m = p (L²/12 + r²) + (1 - p) (L²/4 + r²/2),    p = 2 L / (2 L + π r)
//! ```
//!
//! p is the rectangle's part of the area. The inertia per mass of the rectangle is `(L² + 4 r²) / 12`.
//! The centroid of each half disc is `c = 4 r / 3π` beyond `L/2`. So the inertia per mass of the
//! half discs is `r²/2 - c² + (L/2 + c)² = r²/2 + L²/4 + c L`. The term with `c L` is counted with the
//! rectangle, because `(1 - p) c L = p 2 r²/3`.

use super::{PI, Shape, longer, not_negative, positive};
use crate::error::Error;
use crate::ratio::Ratio;
use crate::scalar::Scalar;

/// A capsule with its centre at the origin. `length` is between the centres of its ends, m; `radius` in m.
/// The length must not be negative, and the radius must be positive.
///
/// ```
/// use fixstep::{dec, mass::{capsule, disc}};
/// let pill = capsule::<f32>(dec!(0.01), dec!(0.003))?;
/// assert!((pill.area().to_f64() - 88.27e-6).abs() < 1e-8); // 2 r L + π r²
/// assert_eq!(capsule::<f32>(0, 2)?, disc(2)?);
/// # Ok::<(), fixstep::Error>(())
/// ```
pub fn capsule<S: Scalar>(
    length: impl Into<Ratio>,
    radius: impl Into<Ratio>,
) -> Result<Shape<S>, Error> {
    let length = not_negative("length", length.into())?;
    let radius = positive("radius", radius.into())?;
    let longest = longer(("radius", radius), ("length", length));
    Shape::about_origin(longest, measures(length, radius))
}

fn measures(length: Ratio, radius: Ratio) -> Option<[Ratio; 2]> {
    let [long, short] = [length.square()?, radius.square()?];
    let twice = length.times(2.into())?;
    let whole = twice.and(PI.times(radius)?)?;
    let straight = long.per(12.into())?.and(short)?;
    let round = long.per(4.into())?.and(short.per(2.into())?)?;
    let part = twice.per(whole)?;
    let others = PI.times(radius)?.per(whole)?;
    let inertia = part.times(straight)?.and(others.times(round)?)?;
    Some([radius.times(whole)?, inertia])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dec;

    #[test]
    fn goes_from_disc_to_rod() {
        let disc = capsule::<f32>(0, 2).unwrap();
        assert_eq!(disc.inertia_per_mass(), dec!(2));
        // A rod has L²/12; with r = 1e-9 L the ends are 1.6e-9 of the mass and add twice L²/12.
        let rod = capsule::<f32>(1, dec!(0.000000001)).unwrap();
        assert!((rod.inertia_per_mass().to_f64() * 12.0 - 1.0).abs() <= 4e-9);
        assert!(capsule::<f32>(1, 0).is_err());
    }
}
