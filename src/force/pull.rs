//! Newton's gravitation between two bodies, softened.
//!
//! ```text
//! d = x2 - x1,  s² = d² + ε²
//! dv1 =  h G m2 d / s³
//! dv2 = -h G m1 d / s³
//! ```
//!
//! Each body has its own coefficient and one rounding, so a grain is drawn to a planet as exactly as
//! a planet to a planet; equal masses get opposite changes to the bit. What the grain does to the
//! planet is rounded too: below half a unit of velocity a step it is nothing. A coefficient ends at
//! `2^30`, where the smallest distance makes a kick of half the range. The squared distance is formed
//! in the wide type: it cannot overflow, only the difference of positions saturates. Where bodies
//! coincide `d` is zero, and so is the pull.
//! Potential `-G m1 m2 / s`: the softening of Plummer. Source: Dehnen, Read, "N-body simulations of
//! gravitational dynamics", Eur. Phys. J. Plus 126 (2011), arXiv:1105.1082.

use crate::body::Body;
use crate::error::Error;
use crate::force::{PairForce, PerStep, ReversiblePair, coefficient};
use crate::ratio::Ratio;
use crate::scalar::{Factor, Scalar};
use crate::time::{Now, TimeStep};

/// Draws two bodies to each other with `F = G m1 m2 d / (d² + ε²)^(3/2)`: the inverse square where
/// they are far apart, and nothing sudden where they are not.
///
/// A body that no force moves has no mass to pull with.
///
/// Close bodies need a small step. Two bodies at distance ε orbit each other at `sqrt(G (m1 + m2) / s³)` rad/s.
/// This rate times h must stay well below 2.
///
/// ```
/// use fixstep::{AllPairs, Pull, prelude::*};
/// let mut world = World::<Point<f64>, 2>::new();
/// let star = world.add(Point::new(vec2(0, 0)?, vec2(0, 0)?, 1000)?)?;
/// let moon = world.add(Point::new(vec2(10, 0)?, vec2(0, 0)?, 1)?)?;
/// let mut pull = AllPairs(Pull::new(1, dec!(0.001))?);
/// world.step(&mut SemiImplicitEuler, &mut pull, &Step::hz(10)?);
/// // G M / d² = 10 m/s², for 1/10 s; the star gets a thousandth of it.
/// assert!((world.get(moon)?.velocity().x + 1.0).abs() < 1e-6);
/// assert!((world.get(star)?.velocity().x - 0.001).abs() < 1e-9);
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Pull<S: Scalar> {
    constant: S::Coef,
    softening: S,
    per_step: PerStep<S, S::Coef>,
    impulse: S::Coef,
}

impl<S: Scalar> Pull<S> {
    /// `constant` is the scene's G in m³/(kg s²), not negative, and `softening` ε in m.
    ///
    /// Refuses values that the scalar or its coefficients cannot hold, and a softening that is not
    /// positive or so small that they cannot hold `G / ε³`: in 32-bit fixed point, from `2^30` on.
    #[inline]
    pub fn new(constant: impl Into<Ratio>, softening: impl Into<Ratio>) -> Result<Pull<S>, Error> {
        let strength = constant.into();
        let constant = coefficient::<S>("constant", strength)?;
        let (field, value) = ("softening", softening.into());
        if value.num() <= 0 {
            return Err(Error::NotPositive { field, value });
        }
        let softening = S::ratio(value).ok_or(Error::OutOfRange { field, value })?;
        if softening == S::ZERO {
            return Err(Error::RoundsToZero { field, value });
        }
        // No distance needs a larger coefficient than ε does.
        let largest = (0..3).try_fold(strength, |product, _| product.over(value));
        let fits = |ratio: Ratio| (ratio.num() as u64) >> S::COEF_BITS < ratio.den();
        if !largest.is_some_and(fits) {
            return Err(Error::OutOfRange { field, value });
        }
        Ok(Pull {
            constant,
            softening,
            per_step: PerStep::new(),
            impulse: constant,
        })
    }
}

/// `k factor³` from the left: each product is in range where the last one is.
#[inline]
fn cubed<S: Scalar>(k: S::Coef, factor: S::Coef) -> S::Coef {
    (0..3).fold(k, |product, _| S::product(product, factor))
}

impl<B: Body> PairForce<B> for Pull<B::S> {
    #[inline]
    fn prepare<H: TimeStep<B::S>>(&mut self, now: &Now<H>) {
        let product = |h| B::S::product(self.constant, h);
        self.impulse = self.per_step.get(&now.step, product);
    }

    #[inline]
    fn act<H: TimeStep<B::S>>(&mut self, _now: &Now<H>, seen: [&B; 2], live: [&mut B; 2]) {
        let along = seen[1].position() - seen[0].position();
        let inverse = B::S::inverse_length(along.array(), self.softening);
        let per_mass = cubed::<B::S>(self.impulse, inverse);
        let [m1, m2] = seen.map(|body| match body.has_infinite_mass() {
            true => B::S::ZERO.coef(),
            false => B::S::mass(body.inv_mass()),
        });
        let [first, second] = live;
        first.kick_by(along, B::S::product(per_mass, m2));
        second.brake_by(along, B::S::product(per_mass, m1));
    }

    fn potential(&self, bodies: [&B; 2]) -> f64 {
        let [a, b] = bodies.map(|body| body.position().to_f64());
        let inverse = f64::inverse_length((b - a).array(), self.softening.to_f64());
        let [w1, w2] = bodies.map(|body| body.inv_mass().to_f64());
        if bodies.iter().any(|body| body.has_infinite_mass()) {
            return 0.0;
        }
        -self.constant.to_f64() * inverse / (w1 * w2)
    }
}

impl<B: Body> ReversiblePair<B> for Pull<B::S> {}
