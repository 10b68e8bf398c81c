//! A polygon, from its vertices.
//!
//! ```text
//! C = x1 y2 - y1 x2                          per edge: twice the triangle with the origin
//! 2 A        = sum(C)
//! 6 A c      = sum(C (r1 + r2))
//! 12 I / ρ   = sum(C (r1·r1 + r1·r2 + r2·r2))        about the origin
//! I / m      = I / ρ / A - |c|²                      about the centre
//! ```
//!
//! By Green's theorem each sum is an exact line integral of a polynomial along the edges. For a
//! clockwise outline all sums have the other sign.
//!
//! All sums are in whole numbers, about the middle of the box around the outline.

use super::{Outline, Shape};
use crate::error::Error;
use crate::scalar::Rational;
use crate::vec2::Vec2;

/// A polygon with an outline that does not cross itself, clockwise or counterclockwise. Vertices are in m.
///
/// The last vertex connects to the first. Vertices must be finite, and the area must not be zero. If an
/// outline crosses itself, its lobes count with opposite signs.
///
/// ```
/// use fixstep::{dec, mass::polygon, vec2, Ratio, fixed::types::I16F16};
/// let corner = |x, y| vec2::<I16F16>(x, y);
/// let angle = [corner(0, 0)?, corner(3, 0)?, corner(3, 1)?, corner(1, 1)?, corner(1, 3)?, corner(0, 3)?];
/// let shape = polygon(&angle)?;
/// assert_eq!((shape.area(), shape.inertia_per_mass()), (dec!(5), Ratio::new(217, 150)?));
/// # Ok::<(), fixstep::Error>(())
/// ```
pub fn polygon<S: Rational>(vertices: &[Vec2<S>]) -> Result<Shape<S>, Error> {
    let outline = Outline::new(vertices)?;
    outline.measured(outline.sums())
}

/// A convex polygon: all corners bend the same way, none is straight, and the outline goes round once.
/// Other outlines are an error. The other errors are those of [`polygon`].
///
/// ```
/// use fixstep::{mass::convex_polygon, vec2, Error};
/// let dart = [vec2::<f32>(0, 0)?, vec2(2, -1)?, vec2(1, 0)?, vec2(2, 1)?];
/// assert_eq!(convex_polygon(&dart).unwrap_err(), Error::NotConvex { vertex: 2 });
/// # Ok::<(), Error>(())
/// ```
pub fn convex_polygon<S: Rational>(vertices: &[Vec2<S>]) -> Result<Shape<S>, Error> {
    let outline = Outline::new(vertices)?;
    let sums = outline.sums();
    let left = sums.area > 0;
    let shape = outline.measured(sums)?;
    match outline.first_bad_corner(left) {
        Some(vertex) => Err(Error::NotConvex { vertex }),
        None => Ok(shape),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ratio::Ratio;
    use crate::{dec, vec2};

    // A right triangle with legs a and b: a b / 2, and (a² + b²) / 18.
    #[test]
    fn a_triangle_either_way_round() {
        let mut corners = [(5, 5), (8, 5), (5, 11)].map(|(x, y)| vec2::<f32>(x, y).unwrap());
        for _ in 0..2 {
            let shape = convex_polygon(&corners).unwrap();
            assert_eq!(shape.area(), dec!(9));
            assert_eq!(shape.inertia_per_mass(), Ratio::new(45, 18).unwrap());
            assert_eq!(shape.centre(), vec2(6, 7).unwrap());
            corners.reverse();
        }
        assert!(polygon(&corners[..2]).is_err());
    }
}
