//! Mass, centre of mass and moment of inertia of bodies and of assemblies.
//!
//! ```text
//! M = sum(m)
//! c = sum(m r) / M
//! I = sum(i + m |r - c|²)         parallel axes: Huygens and Steiner
//! ```
//!
//! A hole is a part with its m and i subtracted. The inertia is about the exact centre. The stored centre
//! is rounded to half a unit of the scalar. Lengths below `2^-62` m count as zero.

use super::{not_negative, positive};
use crate::body::finite;
use crate::error::Error;
use crate::mass::{CentreOfMass, PointMass};
use crate::ratio::Ratio;
use crate::scalar::Rational;
use crate::scalar::Scalar;
use crate::vec2::Vec2;

/// Mass, centre of mass, and moment of inertia about that centre.
///
/// ```
/// use fixstep::{MassProperties, dec, vec2};
/// let wheel = MassProperties::<f32>::new(2, vec2(1, 0)?, dec!(0.5))?;
/// assert_eq!(wheel.inertia_about(vec2(0, 0)?)?, dec!(2.5)); // 0.5 + 2 * 1²
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassProperties<S> {
    mass: Ratio,
    centre: Vec2<S>,
    inertia: Ratio,
}

impl<S: Scalar> MassProperties<S> {
    /// From known values: `mass` in kg, `centre` in m, `inertia` about the centre in kg m².
    /// The mass must be positive, the inertia not negative, and the centre finite.
    pub fn new(
        mass: impl Into<Ratio>,
        centre: Vec2<S>,
        inertia: impl Into<Ratio>,
    ) -> Result<MassProperties<S>, Error> {
        finite("centre", centre)?;
        Ok(MassProperties {
            mass: positive("mass", mass.into())?,
            centre,
            inertia: not_negative("inertia", inertia.into())?,
        })
    }

    /// Mass, kg; greater than zero.
    #[must_use]
    pub fn mass(&self) -> Ratio {
        self.mass
    }

    /// Centre of mass, m.
    #[must_use]
    pub fn centre(&self) -> Vec2<S> {
        self.centre
    }

    /// Moment of inertia about the centre, kg m²; not negative.
    #[must_use]
    pub fn inertia(&self) -> Ratio {
        self.inertia
    }

    /// The same body, moved by the vector `position`. The new centre must be finite and in range.
    pub fn at(&self, position: Vec2<S>) -> Result<MassProperties<S>, Error> {
        let (field, centre) = ("position", self.centre + position);
        match centre.is_inside() {
            true => Ok(MassProperties { centre, ..*self }),
            false => Err(Error::NotFinite { field }),
        }
    }
}

impl<S: Rational> MassProperties<S> {
    /// Moment of inertia about a point, kg m². The point must be finite and near enough for 62 bits.
    ///
    /// ```
    /// use fixstep::{dec, mass::rectangle, vec2};
    /// let door = rectangle::<f32>(1, dec!(0.25))?.with_mass(48)?;
    /// let hinge = vec2(dec!(0.5), 0)?;
    /// assert_eq!(door.inertia_about(hinge)?, dec!(16.25));
    /// # Ok::<(), fixstep::Error>(())
    /// ```
    pub fn inertia_about(&self, point: Vec2<S>) -> Result<Ratio, Error> {
        let about = || self.part()?.inertia_about(place(point)?);
        about().ok_or(Error::NotFinite { field: "point" })
    }

    /// Point masses that do not move relative to each other. The errors are those of
    /// [`CentreOfMass::new`], and sums that 62 bits cannot hold.
    pub fn from_points(points: &[PointMass<S>]) -> Result<MassProperties<S>, Error> {
        CentreOfMass::new(points)?;
        let parts = points.iter().map(|point| {
            let (mass, inertia) = (point.mass, Ratio::ZERO);
            let place = place(point.position)?;
            Some(Part {
                mass,
                place,
                inertia,
            })
        });
        whole(parts).ok_or(Error::NotFinite { field: "points" })
    }

    /// Parts that are fixed to each other, each at its [`centre`](Self::centre). There must be at least
    /// one part, and 62 bits must hold the sums.
    ///
    /// ```
    /// use fixstep::{dec, mass::{disc, rectangle}, vec2, MassProperties};
    /// let head = rectangle::<f32>(dec!(0.1), dec!(0.04))?.with_mass(dec!(0.5))?;
    /// let handle = rectangle::<f32>(dec!(0.02), dec!(0.3))?.with_mass(dec!(0.2))?;
    /// let hammer = MassProperties::from_parts(&[head, handle.at(vec2(0, dec!(-0.17))?)?])?;
    /// assert_eq!(hammer.mass(), dec!(0.7));
    /// # Ok::<(), fixstep::Error>(())
    /// ```
    pub fn from_parts(parts: &[MassProperties<S>]) -> Result<MassProperties<S>, Error> {
        let field = "parts";
        if parts.is_empty() {
            return Err(Error::Empty { field });
        }
        whole(parts.iter().map(Self::part)).ok_or(Error::NotFinite { field })
    }

    /// Cuts out `hole`, which must be inside the body. Its mass must be less than that of the body, and the
    /// remaining inertia must not be negative.
    ///
    /// ```
    /// # use fixstep::{dec, mass::rectangle};
    /// let plate = rectangle::<f32>(2, 2)?.with_density(3)?; // 12 kg, 8 kg m²
    /// let hole = rectangle(1, 1)?.with_density(3)?; // 3 kg, 0.5 kg m²
    /// assert_eq!(plate.without(&hole)?.inertia(), dec!(7.5));
    /// # Ok::<(), fixstep::Error>(())
    /// ```
    pub fn without(&self, hole: &MassProperties<S>) -> Result<MassProperties<S>, Error> {
        let (field, value) = ("hole", hole.mass);
        let (left, too_far) = (self.mass.less(value), Error::NotFinite { field });
        if left.ok_or(too_far)?.num() <= 0 {
            return Err(Error::OutOfRange { field, value });
        }
        let parts = [self.part(), hole.part().and_then(Part::taken_away)];
        let others = whole(parts.into_iter()).ok_or(too_far)?;
        match others.inertia.num() {
            ..0 => Err(Error::OutOfRange {
                field,
                value: hole.inertia,
            }),
            _ => Ok(others),
        }
    }

    fn part(&self) -> Option<Part> {
        let place = place(self.centre)?;
        Some(Part {
            mass: self.mass,
            place,
            inertia: self.inertia,
        })
    }
}

/// Mass properties as fractions.
#[derive(Clone, Copy)]
struct Part {
    mass: Ratio,
    place: [Ratio; 2],
    inertia: Ratio,
}

impl Part {
    fn taken_away(self) -> Option<Part> {
        Some(Part {
            mass: self.mass.signed(true, false)?,
            inertia: self.inertia.signed(true, false)?,
            ..self
        })
    }

    fn inertia_about(self, [x, y]: [Ratio; 2]) -> Option<Ratio> {
        let [dx, dy] = [self.place[0].less(x)?, self.place[1].less(y)?];
        let square = dx.square()?.and(dy.square()?)?;
        self.inertia.and(self.mass.times(square)?)
    }
}

/// All parts together; `None` if 62 bits cannot hold a sum.
fn whole<S: Rational>(
    parts: impl Iterator<Item = Option<Part>> + Clone,
) -> Option<MassProperties<S>> {
    let (mut mass, mut moment) = (Ratio::ZERO, [Ratio::ZERO; 2]);
    for part in parts.clone() {
        let part = part?;
        mass = mass.and(part.mass)?;
        for (sum, x) in moment.iter_mut().zip(part.place) {
            *sum = sum.and(part.mass.times(x)?)?;
        }
    }
    let centre = [moment[0].per(mass)?, moment[1].per(mass)?];
    let mut inertia = Ratio::ZERO;
    for part in parts {
        inertia = inertia.and(part?.inertia_about(centre)?)?;
    }
    let [x, y] = centre.map(S::ratio);
    Some(MassProperties {
        mass,
        centre: Vec2::new(x?, y?),
        inertia,
    })
}

/// A vector as fractions of 62 bits.
fn place<S: Rational>(vector: Vec2<S>) -> Option<[Ratio; 2]> {
    let component = |value: S| {
        let (mantissa, exponent) = value.binary()?;
        let size = Ratio::scaled(mantissa.unsigned_abs().into(), 1, exponent)?;
        size.signed(mantissa < 0, false)
    };
    Some([component(vector.x)?, component(vector.y)?])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{dec, vec2};

    // Two points of 1 kg and 3 kg, 4 m apart: c is 1 m from the second, I = 1 3² + 3 1² = 12.
    #[test]
    fn two_points() {
        let part = |x, mass| MassProperties::<f32>::new(mass, vec2(x, 0).unwrap(), 0).unwrap();
        let whole = MassProperties::from_parts(&[part(10, 1), part(14, 3)]).unwrap();
        assert_eq!(
            whole,
            MassProperties::new(4, vec2(13, 0).unwrap(), 12).unwrap()
        );
        assert_eq!(whole.inertia_about(vec2(13, -2).unwrap()), Ok(dec!(28)));
        assert_eq!(whole.without(&part(14, 3)), Ok(part(10, 1)));
        assert!(part(0, 1).without(&part(0, 1)).is_err());
    }
}
