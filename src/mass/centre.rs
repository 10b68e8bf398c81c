//! A body made of point masses: what the set amounts to.
//!
//! ```text
//! M   = sum(m)
//! r   = sum(m r) / M        centre of mass
//! v   = sum(m v) / M        its velocity
//! p   = sum(m v) = M v      momentum of the whole
//! ```
//!
//! Masses are exact fractions, so no sum of them overflows a scalar; a point enters with its weight
//! `m / M`, which is a coefficient. Each product is rounded once: n points put the centre at most
//! `n / 2` units off, at the end of the range one more, and never outside of it.
//! Source: Hecker, "Physics, The Next Frontier" (1996), Eq. 7 to 10.

use crate::body::{Point, finite};
use crate::error::Error;
use crate::ratio::Ratio;
use crate::scalar::{Factor, Scalar};
use crate::vec2::Vec2;

/// One of the points that a body is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointMass<S> {
    /// Where it is, m.
    pub position: Vec2<S>,
    /// How it moves, m/s; the same for all points of a body that does not turn.
    pub velocity: Vec2<S>,
    /// Its mass, kg.
    pub mass: Ratio,
}

/// What a set of point masses amounts to, seen from afar.
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
    /// Of all `points` together.
    ///
    /// Refuses an empty set, a mass that is not positive, a total that 62 bits cannot hold to ten
    /// digits, and points that are NaN or infinite.
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
    /// let body = whole.point()?; // to be added to a world
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

    /// Momentum of the whole, kg m/s; for reports.
    #[must_use]
    pub fn momentum(&self) -> Vec2<f64> {
        self.velocity.to_f64().map(|v| v * self.mass.to_f64())
    }

    /// The point that moves as the centre does, under the sum of all forces. Refuses a mass that
    /// [`Point::new`] refuses.
    pub fn point(&self) -> Result<Point<S>, Error> {
        Point::new(self.position, self.velocity, self.mass)
    }
}

/// The sum of all masses, none of which may be zero or less.
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
