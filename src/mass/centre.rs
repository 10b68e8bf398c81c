//! A set of point masses: its mass, centre of mass and velocity.
//!
//! ```text
//! M   = sum(m)
//! r   = sum(m r) / M        centre of mass
//! v   = sum(m v) / M        its velocity
//! p   = sum(m v) = M v      momentum of the whole
//! ```
//!
//! Masses are exact fractions, so no sum of them overflows a scalar. Each point has the weight
//! `m / M`, which is a coefficient. Each product is rounded once. With n points the error of the centre
//! is at most `n / 2` units, and one more at the end of the range. It never leaves the range.
//! Source: Hecker, "Physics, The Next Frontier" (1996), Eq. 7 to 10.

use crate::body::{Point, finite};
use crate::error::Error;
use crate::ratio::Ratio;
use crate::scalar::{Factor, Scalar};
use crate::vec2::Vec2;

/// One point of a set of point masses.
///
/// ```
/// use fixstep::{CentreOfMass, PointMass, dec, vec2};
/// let ball = PointMass { position: vec2::<f32>(2, 0)?, velocity: vec2(0, 0)?, mass: dec!(3) };
/// let whole = CentreOfMass::new(&[ball, ball])?;
/// assert_eq!((whole.mass, whole.position), (dec!(6), vec2(2, 0)?));
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointMass<S> {
    /// Position, m.
    pub position: Vec2<S>,
    /// Velocity, m/s; the same for all points of a body that does not rotate.
    pub velocity: Vec2<S>,
    /// Its mass, kg.
    pub mass: Ratio,
}

/// The total mass, the centre of mass and its velocity, for a set of point masses.
///
/// ```
/// use fixstep::{CentreOfMass, PointMass, dec, vec2};
/// let at_rest = PointMass { position: vec2::<f32>(0, 0)?, velocity: vec2(0, 0)?, mass: dec!(1) };
/// let moving = PointMass { position: vec2(4, 0)?, velocity: vec2(4, 0)?, mass: dec!(3) };
/// let whole = CentreOfMass::new(&[at_rest, moving])?;
/// assert_eq!((whole.position, whole.velocity), (vec2(3, 0)?, vec2(3, 0)?));
/// assert_eq!(whole.momentum().x, 12.0); // 4 kg at 3 m/s
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct CentreOfMass<S> {
    /// Total mass, kg.
    pub mass: Ratio,
    /// Centre of mass, m.
    pub position: Vec2<S>,
    /// Velocity of the centre of mass, m/s.
    pub velocity: Vec2<S>,
}

impl<S: Scalar> CentreOfMass<S> {
    /// The centre of mass of all `points` together.
    ///
    /// There must be at least one point. Masses must be positive, and 62 bits must hold their total to
    /// ten digits. NaN and infinity are errors.
    ///
    /// ```
    /// use fixstep::mass::{CentreOfMass, PointMass};
    /// use fixstep::{dec, vec2, Ratio, Vec2, fixed::types::I16F16};
    /// // A dumb-bell: 1 kg on the left, 3 kg on the right.
    /// let ball = |x, kilograms| {
    ///     let position = vec2::<I16F16>(x, 0)?;
    ///     Ok::<_, fixstep::Error>(PointMass { position, velocity: Vec2::ZERO, mass: kilograms })
    /// };
    /// let whole = CentreOfMass::new(&[ball(-2, dec!(1))?, ball(2, dec!(3))?])?;
    /// assert_eq!((whole.mass, whole.position), (dec!(4), vec2(1, 0)?));
    /// let body = whole.point()?; // ready for `World::add`
    /// # Ok::<(), fixstep::Error>(())
    /// ```
    pub fn new(points: &[PointMass<S>]) -> Result<CentreOfMass<S>, Error> {
        let mass = total(points)?;
        let mut whole = CentreOfMass {
            mass,
            position: Vec2::ZERO,
            velocity: Vec2::ZERO,
        };
        for point in points {
            finite("position", point.position)?;
            finite("velocity", point.velocity)?;
            // A weight too small for a coefficient moves the centre by less than half a unit.
            let Some(weight) = point.mass.over(mass).and_then(S::Coef::new) else {
                continue;
            };
            whole.position += point.position.scaled(weight);
            whole.velocity += point.velocity.scaled(weight);
        }
        Ok(whole)
    }

    /// Total momentum, kg m/s; for reports.
    #[must_use]
    pub fn momentum(&self) -> Vec2<f64> {
        self.velocity.to_f64().map(|v| v * self.mass.to_f64())
    }

    /// A point with the total mass, which moves like the centre with the sum of all forces. The errors are
    /// those of [`Point::new`].
    pub fn point(&self) -> Result<Point<S>, Error> {
        Point::new(self.position, self.velocity, self.mass)
    }
}

/// The sum of all masses, which must all be positive.
fn total<S>(points: &[PointMass<S>]) -> Result<Ratio, Error> {
    let field = "mass";
    let mut total = Ratio::ZERO;
    for &PointMass { mass: value, .. } in points {
        if value.num() <= 0 {
            return Err(Error::NotPositive { field, value });
        }
        total = total
            .plus(value)
            .ok_or(Error::OutOfRange { field, value })?;
    }
    match total.num() {
        0 => Err(Error::Empty { field: "points" }),
        _ => Ok(total),
    }
}
