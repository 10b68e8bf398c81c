//! A scene's coefficients as a scalar works with them.
//!
//! A scalar rounds start values, masses, coefficients and the step when the scene is built. That is
//! an error of its own: the run follows another law from another start. A step has its length
//! twice, `h_k` for kicks (a `Coef`) and `h_d` for drifts (a `Span`), and both differ from the true
//! `h`. The reference keeps the true `h`; with `u = v h_d / h` in place of v,
//!
//! ```text
//! v' = v + h_k a        u' = u + h (a h_k h_d / h²)
//! x' = x + h_d v'       x' = x + h u'
//! ```
//!
//! so a wrong step is a right step with other coefficients:
//!
//! ```text
//! velocity v h_d/h      gravity g h_k h_d/h²      drag k h_k/h      stiffness k h_k h_d/h²
//! ```
//!
//! `h_d` is the mean of the two spans that take turns. Products that depend on no state (`k h`, `g h`,
//! `k h / m`) are taken as the scalar makes them. What is left, and counts as rounding of the state,
//! is what happens to the state in every step.

use fixstep::scalar::Factor;
use fixstep::{Body, Error, Point, Ratio, Scalar, Vec2};

use crate::scene::{Law, Start};

/// A real number as constructors take it.
pub fn real(value: f64) -> Result<Ratio, Error> {
    Ok(Ratio::from_f64(value)?)
}

/// A vector of real numbers in a scalar.
pub fn vector<S: Scalar>(v: Vec2<f64>) -> Result<Vec2<S>, Error> {
    fixstep::vec2(real(v.x)?, real(v.y)?)
}

/// The body as the crate holds it.
pub fn point<S: Scalar>(start: &Start) -> Result<Point<S>, Error> {
    Point::new(
        vector(start.position)?,
        vector(start.velocity)?,
        real(start.mass)?,
    )
}

/// A step of true length `h` as the scalar has it.
pub struct Represented<S: Scalar> {
    h: f64,
    coef: S::Coef,
    drift: f64,
}

impl<S: Scalar> Represented<S> {
    pub fn new(seconds: Ratio) -> Result<Self, Error> {
        let lost = Error::OutOfRange {
            field: "seconds",
            value: seconds,
        };
        let h = seconds.to_f64();
        let coef = S::Coef::new(seconds).ok_or(lost)?;
        let [below, above] = S::spans(seconds).ok_or(lost)?;
        Ok(Represented {
            h,
            coef,
            drift: (below.to_f64() + above.to_f64()) / (2.0 * h),
        })
    }

    /// The start values that the scalar flies from.
    pub fn body(&self, start: &Start) -> Result<Start, Error> {
        let point = point::<S>(start)?;
        Ok(Start {
            position: point.position().to_f64(),
            velocity: point.velocity().to_f64().scaled(self.drift),
            mass: 1.0 / point.inv_mass().to_f64(),
        })
    }

    /// The law that the scalar follows with bodies like `start`.
    pub fn law(&self, law: Law, start: &Start) -> Result<Law, Error> {
        Ok(match law {
            Law::Free => Law::Free,
            Law::Gravity { g } => Law::Gravity {
                g: self.gravity(g)?,
            },
            Law::Drag { k } => Law::Drag {
                k: self.per_mass(k, start)?,
            },
            Law::GravityAndDrag { g, k } => Law::GravityAndDrag {
                g: self.gravity(g)?,
                k: self.per_mass(k, start)?,
            },
            Law::Anchor { k } => Law::Anchor {
                k: self.per_mass(k, start)? * self.drift,
            },
            Law::Spring { k, rest } => {
                let rest = vector::<S>(Vec2::new(rest, 0.0))?.to_f64().x;
                Law::Spring {
                    k: self.per_second(k)? * self.drift,
                    rest,
                }
            }
        })
    }

    /// `k h_k / h`, with the product as the scalar rounds it.
    fn per_second(&self, k: f64) -> Result<f64, Error> {
        Ok(self.per_step(k)?.to_f64() / self.h)
    }

    /// The same for a force on one body, which multiplies by `1/m` before it meets the state.
    fn per_mass(&self, k: f64, start: &Start) -> Result<f64, Error> {
        let inv_mass = point::<S>(start)?.inv_mass();
        let product = S::product(self.per_step(k)?, inv_mass.into());
        Ok(product.to_f64() / (inv_mass.to_f64() * self.h))
    }

    fn per_step(&self, k: f64) -> Result<S::Coef, Error> {
        let value = real(k)?;
        let coef = S::Coef::new(value).ok_or(Error::OutOfRange { field: "k", value })?;
        Ok(S::product(coef, self.coef))
    }

    /// The mean gain of a step: fixed point spreads its fraction over the ticks.
    fn gravity(&self, g: f64) -> Result<f64, Error> {
        const TICKS: u64 = 1 << 18;
        let gain = vector::<S>(Vec2::new(g, 0.0))?.x.gain(self.coef);
        let gained = |tick| S::gained(gain, tick).to_f64();
        let more: f64 = (0..TICKS).map(|tick| gained(tick) - gained(0)).sum();
        Ok((gained(0) + more / TICKS as f64) / self.h * self.drift)
    }
}
