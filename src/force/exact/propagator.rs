//! What a spring does to a displacement and a velocity in one step, in coefficients of a scalar.
//!
//! ```text
//! damped      x' = x + (p11 - 1) z + p12 v      v' = v + p21 z + (p22 - 1) v
//! undamped    x½ = x + α v,  v' = v + β z½,  x' = x½ + α v'     after a rotation by half a turn where cos is negative
//! ```
//!
//! z is the displacement from the rest position. Without damping the step is a rotation of (z, v). Three shears make this
//! rotation with three products. Whatever their roundings, area is kept to the bit. So an undamped spring neither
//! gains nor loses over any number of steps. The four rounded entries of a matrix have a determinant that is off by a
//! unit of their last digit in every step.
//! Source of the shears: Paeth, "A fast algorithm for general raster rotation", Graphics Interface
//! 1986.

use super::oscillation::Oscillation;
use crate::body::Body;
use crate::error::Error;
use crate::ratio::Ratio;
use crate::scalar::{Factor, Scalar};
use crate::vec2::Vec2;

/// One step of an oscillator.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Propagator<S: Scalar> {
    /// `[p11 - 1, p12, p21, p22 - 1]`.
    Damped([S::Coef; 4]),
    /// Whether a rotation by half a turn comes first, α and β.
    Turn(bool, [S::Coef; 2]),
}

/// A spring and the length of a step in numbers that are not rounded yet.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Swing {
    pub(crate) hertz: Ratio,
    pub(crate) damping_ratio: Ratio,
}

impl Swing {
    /// Refuses a frequency that is not positive, below `2^-20` or from `2^20` on, and a damping ratio
    /// that is negative or from `2^10` on.
    pub(crate) fn new(hertz: Ratio, damping_ratio: Ratio) -> Result<Swing, Error> {
        let (field, value) = ("hertz", hertz);
        if value.num() <= 0 {
            return Err(Error::NotPositive { field, value });
        }
        if !(-19..=20).contains(&value.exponent_above()) {
            return Err(Error::OutOfRange { field, value });
        }
        let (field, value) = ("damping_ratio", damping_ratio);
        if value.num() < 0 {
            return Err(Error::Negative { field, value });
        }
        if value.exponent_above() > 10 {
            return Err(Error::OutOfRange { field, value });
        }
        Ok(Swing {
            hertz,
            damping_ratio,
        })
    }

    /// Energy of a displacement, J.
    pub(crate) fn potential(self, z: Vec2<f64>, inv_mass: f64) -> f64 {
        if inv_mass == 0.0 {
            return 0.0;
        }
        let omega = core::f64::consts::TAU * self.hertz.to_f64();
        0.5 * omega * omega * z.dot(z) / inv_mass
    }
}

/// A step of `seconds`, or half of it.
pub(crate) fn length(seconds: Ratio, whole: bool) -> Ratio {
    match whole {
        true => seconds,
        false => seconds.halved().unwrap_or(seconds),
    }
}

impl<S: Scalar> Propagator<S> {
    /// A step of `seconds`. If a coefficient cannot hold an entry, the step moves nothing.
    pub(crate) fn new(swing: Swing, seconds: Ratio) -> Self {
        Self::of(swing, seconds).unwrap_or(Propagator::Turn(false, [S::ZERO.coef(); 2]))
    }

    fn of(swing: Swing, seconds: Ratio) -> Option<Self> {
        if swing.damping_ratio.num() != 0 {
            return Some(Propagator::Damped(Self::entries(swing, seconds)));
        }
        let step = Oscillation::new(swing.hertz, swing.damping_ratio, seconds)?;
        let (over, shears) = step.shears()?;
        Some(Propagator::Turn(over, shears.map(coef::<S>)))
    }

    /// `[p11 - 1, p12, p21, p22 - 1]` of a step of `seconds`; zero where no coefficient holds them.
    pub(crate) fn entries(swing: Swing, seconds: Ratio) -> [S::Coef; 4] {
        let entries = || {
            let step = Oscillation::new(swing.hertz, swing.damping_ratio, seconds)?;
            let ([p11, p22], [p12, p21]) = (step.gains()?, step.exchanges()?);
            Some([p11, p12, p21, p22])
        };
        entries().map_or([S::ZERO.coef(); 4], |entries| entries.map(coef::<S>))
    }

    /// Moves one body about `rest`.
    #[inline]
    pub(crate) fn apply<B: Body<S = S>>(self, rest: Vec2<S>, body: &mut B) {
        match self {
            Propagator::Damped(entries) => body.swing(rest, entries),
            Propagator::Turn(over, [forth, back]) => {
                if over {
                    body.mirror(rest);
                }
                body.drift_by(forth);
                body.kick_from(rest, back);
                body.drift_by(forth);
            }
        }
    }
}

/// A coefficient too small to be held moves nothing by as much as a unit.
#[inline(never)]
fn coef<S: Scalar>(ratio: Ratio) -> S::Coef {
    S::Coef::new(ratio).unwrap_or(S::ZERO.coef())
}
