//! Mass, centre of mass and moment of inertia of shapes.
//!
//! | shape | area, m² | inertia per mass, m², about its centre |
//! |---|---|---|
//! | [`disc`](disc()) | `π r²` | `r² / 2` |
//! | [`ring`](ring()) | `π (R² - r²)` | `(R² + r²) / 2` |
//! | [`rectangle`](rectangle()) | `w h` | `(w² + h²) / 12` |
//! | [`capsule`](capsule()) | `2 r L + π r²` | `p (L²/12 + r²) + (1 - p) (L²/4 + r²/2)`, `p = 2 L / (2 L + π r)` |
//! | [`polygon`](polygon()), [`convex_polygon`] | by Green's theorem | by Green's theorem |
//!
//! With a mass, or a density in kg per m², a shape becomes [`MassProperties`]. These can be moved and
//! joined, and holes can be cut out. All arithmetic is in integer fractions with a relative error of some
//! `2^-60`. Only a centre is stored in a scalar; it is rounded once, to half a unit. Areas in m² are
//! [`Ratio`]s too: no shape is wider than `2^30` m, and an area below `2^-62` m² counts as zero.
//!
//! A gear with 16 teeth and a bore, of steel 10 mm thick, on its axle:
//!
//! ```
//! use fixstep::mass::{disc, polygon};
//! use fixstep::{Error, Ratio, Vec2, dec, fixed::types::I8F24, vec2};
//!
//! let corner = |i: u32| {
//!     let angle = f64::from(i) * core::f64::consts::TAU / 64.0;
//!     let radius = if i % 4 < 2 { 0.10 } else { 0.09 };
//!     let [x, y] = [angle.cos(), angle.sin()].map(|part| Ratio::from_f64(radius * part));
//!     vec2::<I8F24>(x?, y?)
//! };
//! let mut outline = [Vec2::ZERO; 64];
//! for (i, vertex) in (0..).zip(&mut outline) {
//!     *vertex = corner(i)?;
//! }
//! let steel = dec!(78); // kg per m²
//! let bore = disc(dec!(0.02))?.with_density(steel)?;
//! let gear = polygon(&outline)?.with_density(steel)?.without(&bore)?;
//! let on_its_axle = gear.at(vec2(1, dec!(0.5))?)?;
//! assert!((gear.mass().to_f64() - 2.11).abs() < 0.001);
//! assert_eq!(on_its_axle.inertia(), gear.inertia());
//! # Ok::<(), Error>(())
//! ```

mod capsule;
mod centre;
mod disc;
mod outline;
mod polygon;
mod properties;
mod rectangle;
mod ring;

use outline::Outline;

use crate::error::Error;
use crate::ratio::Ratio;
use crate::scalar::Scalar;
use crate::vec2::Vec2;

pub use capsule::capsule;
pub use centre::{CentreOfMass, PointMass};
pub use disc::disc;
pub use polygon::{convex_polygon, polygon};
pub use properties::MassProperties;
pub use rectangle::rectangle;
pub use ring::ring;

/// π with a relative error of `2^-73`. It is short enough that most products are exact.
const PI: Ratio = match Ratio::new(21_053_343_141, 6_701_487_259) {
    Ok(ratio) => ratio,
    Err(_) => Ratio::ZERO,
};

/// A flat shape of uniform density, in its own axes.
///
/// ```
/// use fixstep::{dec, mass::rectangle};
/// let card = rectangle::<f32>(3, 4)?;
/// assert_eq!(card.area(), dec!(12));
/// assert_eq!(card.with_mass(12)?.inertia(), dec!(25)); // m (w² + h²) / 12
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape<S> {
    area: Ratio,
    centre: Vec2<S>,
    inertia_per_mass: Ratio,
}

impl<S: Scalar> Shape<S> {
    /// A shape about the origin. The error names `field`, a length, if a square does not fit.
    fn about_origin(
        (field, value): (&'static str, Ratio),
        area_and_inertia: Option<[Ratio; 2]>,
    ) -> Result<Shape<S>, Error> {
        let [area, inertia_per_mass] =
            area_and_inertia.ok_or(Error::OutOfRange { field, value })?;
        if inertia_per_mass.num() == 0 {
            return Err(Error::RoundsToZero { field, value });
        }
        Ok(Shape {
            area,
            centre: Vec2::ZERO,
            inertia_per_mass,
        })
    }

    /// Area, m²; zero for a hoop.
    #[must_use]
    pub fn area(&self) -> Ratio {
        self.area
    }

    /// Centroid in the shape's own axes, m.
    #[must_use]
    pub fn centre(&self) -> Vec2<S> {
        self.centre
    }

    /// Moment of inertia about the centre per mass, m²: the square of the radius of gyration.
    #[must_use]
    pub fn inertia_per_mass(&self) -> Ratio {
        self.inertia_per_mass
    }

    /// The shape with a mass, kg. The mass must be positive, and 62 bits must hold the moment of inertia.
    pub fn with_mass(&self, mass: impl Into<Ratio>) -> Result<MassProperties<S>, Error> {
        let mass = positive("mass", mass.into())?;
        let inertia = product(("mass", mass), self.inertia_per_mass)?;
        MassProperties::new(mass, self.centre, inertia)
    }

    /// The shape with a density, kg per m². The density and the area must be positive. The other errors
    /// are those of [`with_mass`](Shape::with_mass).
    ///
    /// ```
    /// use fixstep::{dec, mass::rectangle};
    /// let door = rectangle::<f32>(dec!(0.8), 2)?.with_density(dec!(12.5))?;
    /// assert_eq!(door.mass(), dec!(20));
    /// # Ok::<(), fixstep::Error>(())
    /// ```
    pub fn with_density(&self, density: impl Into<Ratio>) -> Result<MassProperties<S>, Error> {
        let density = positive("density", density.into())?;
        let area = positive("area", self.area)?;
        self.with_mass(product(("density", density), area)?)
    }
}

/// `value * by` for positive numbers. The error names `field` if 62 bits cannot hold the product.
fn product((field, value): (&'static str, Ratio), by: Ratio) -> Result<Ratio, Error> {
    match value.times(by) {
        None => Err(Error::OutOfRange { field, value }),
        Some(product) if product.num() == 0 => Err(Error::RoundsToZero { field, value }),
        Some(product) => Ok(product),
    }
}

fn positive(field: &'static str, value: Ratio) -> Result<Ratio, Error> {
    match value.num() {
        ..=0 => Err(Error::NotPositive { field, value }),
        _ => Ok(value),
    }
}

/// The longer of two lengths, with its name.
fn longer(a: (&'static str, Ratio), b: (&'static str, Ratio)) -> (&'static str, Ratio) {
    let sides = [(a, b), (b, a)].map(|(a, b)| a.1.num() as i128 * b.1.den() as i128);
    if sides[0] < sides[1] { b } else { a }
}

fn not_negative(field: &'static str, value: Ratio) -> Result<Ratio, Error> {
    match value.num() {
        ..0 => Err(Error::Negative { field, value }),
        _ => Ok(value),
    }
}
