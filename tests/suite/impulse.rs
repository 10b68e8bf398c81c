//! An impulse at a point of a body: what it does at once, and how the body flies on.
//!
//! ```text
//! v += J w          w = 1/m as the body holds it
//! s += r×J i        i = 1 / 2πI as the body holds it
//! ```
//!
//! References are `f64`: a product of a 32-bit number with a factor is off by 2^-53 of itself there, less than
//! 2^-21 of a unit.

#[path = "impulse/kinds.rs"]
mod kinds;
#[path = "impulse/mirror.rs"]
mod mirror;
#[path = "impulse/points.rs"]
mod points;
use crate::support;

use std::fmt::Debug;

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::rigid::Centre;
use fixstep::{
    Body, Carried, CarryAngular, Decay, Factor, Point, Rigid, Rotating, Scalar, Vec2, dec, vec2,
};
use support::*;

/// What roundings are in a number type.
trait Rounds: Format + CarryAngular + Decay {
    /// Of a sum of this size, at most: none in fixed point.
    fn sum(at: f64) -> f64;

    /// Of `a b + c d` and its mantissa, as a part of `|a b| + |c d|`. Fixed point adds in full and cuts the sum to
    /// 31 bits; a float rounds two products and their sum.
    const SUM_OF_PRODUCTS: f64;

    /// Of the inverse of a mass: 26 bits in fixed point.
    const INVERSE: f64;

    /// How far a cosine or a sine may be off.
    const CIRCLE: f64;

    /// How much larger errors may be as the reference has no more digits.
    const REFERENCE: f64 = 1.0;
}

macro_rules! fixed_rounds {
    ($($fixed:ty),*) => {
        $(impl Rounds for $fixed {
            fn sum(_: f64) -> f64 {
                0.0
            }

            const SUM_OF_PRODUCTS: f64 = 1.0 / (1_u64 << 30) as f64;
            const INVERSE: f64 = 1.0 / (1_u64 << 26) as f64;
            const CIRCLE: f64 = 1.0 / (1_u64 << 30) as f64;
        })*
    };
}

macro_rules! float_rounds {
    ($float:ident, $circle:expr, $reference:expr) => {
        impl Rounds for $float {
            fn sum(at: f64) -> f64 {
                0.5 * Self::unit(at)
            }

            const SUM_OF_PRODUCTS: f64 = 1.01 * $float::EPSILON as f64;
            const INVERSE: f64 = 0.5 * $float::EPSILON as f64;
            const CIRCLE: f64 = $circle + 0.25 * $float::EPSILON as f64;
            const REFERENCE: f64 = $reference;
        }
    };
}

fixed_rounds!(I16F16, I8F24);
float_rounds!(f32, 1.0 / (1_u64 << 30) as f64, 1.0);
float_rounds!(f64, 0.0, 2.0);

/// A centre of mass in such a number type.
trait Middle: Centre<S: Rounds> + From<Point<Self::S>> + PartialEq + Debug {}

impl<C: Centre<S: Rounds> + From<Point<C::S>> + PartialEq + Debug> Middle for C {}

/// Numbers that look random, of some size.
struct Draw(Random);

impl Draw {
    /// From `-size` to `size`.
    fn within(&mut self, size: f64) -> f64 {
        size * ((self.0.next() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0)
    }

    fn vector<S: Scalar>(&mut self, size: f64) -> Vec2<S> {
        vector(self.within(size), self.within(size))
    }

    /// Between the two, evenly by its logarithm.
    fn between(&mut self, low: f64, high: f64) -> f64 {
        let middle = (low * high).sqrt();
        middle * (high / middle).powf(self.within(1.0))
    }

    /// 0.1 to 1000 kg, 0.2 to 1000 kg m², up to 5 m/s and 5 turns/s: no impulse of 8 kg m/s at 4 m leaves the
    /// range of an `I8F24`, as `8 / 0.1 + 5 < 128` and `2 4 8 / (2π 0.2) + 5 < 128`.
    fn body<C: Middle>(&mut self) -> Rigid<C> {
        let (mass, inertia) = (self.between(0.1, 1000.0), self.between(0.2, 1000.0));
        let (position, velocity) = (self.vector(20.0), self.vector(5.0));
        let centre = Point::new(position, velocity, ratio(mass)).unwrap();
        let body = Rigid::new(C::from(centre), ratio(inertia)).unwrap();
        let turned = fixstep::Angle::turns(ratio(self.within(0.5)));
        let spin = ratio(self.within(5.0));
        body.with_angle(turned).with_spin(spin).unwrap()
    }
}

/// The largest error by what is allowed.
fn report<S: Format>(what: &str, shares: &[f64]) {
    within(
        1.0,
        &format!("{} {what}, of what is allowed", S::name()),
        shares,
    );
}

/// Velocity: the product is rounded to half a unit, in floats the sum once more. Spin: in the same way, and the
/// perpendicular product before that. A body that carries sees a remainder rounded: its velocity is one whose
/// momentum is a whole number of units, two units of 2^-15 from the exact one at most, and found by a mass that
/// is the inverse of the inverse, off by 2^-30; its spin is off by half a unit of 2^-15.
fn check_impulses<C: Middle>(what: &str, remainder: f64) {
    let mut draw = Draw(Random(1));
    let inverse_of_inverse = if remainder > 0.0 {
        0.5_f64.powi(30)
    } else {
        0.0
    };
    let (mut velocities, mut spins) = (Vec::new(), Vec::new());
    for _ in 0..long(10_000) {
        let mut body = draw.body::<C>();
        let start = body;
        let (arm, impulse) = (draw.vector::<C::S>(4.0), draw.vector::<C::S>(8.0));
        body.push_off(arm, impulse);
        let inv_mass = body.inv_mass().to_f64();
        let (r, j) = (arm.to_f64(), impulse.to_f64());
        for (before, after, j) in [
            (start.velocity().x, body.velocity().x, j.x),
            (start.velocity().y, body.velocity().y, j.y),
        ] {
            let (change, after) = (j * inv_mass, after.to_f64());
            let allowed = (0.5 + 2.0 * remainder) * C::S::unit(change)
                + inverse_of_inverse * change.abs()
                + C::S::sum(after);
            let error = (after - before.to_f64() - change).abs();
            velocities.push(error / (C::S::REFERENCE * allowed + 2e-7 * C::S::unit(0.0)));
        }
        let inverse = body.inv_inertia().to_f64();
        let change = (r.x * j.y - r.y * j.x) * inverse;
        let products = (r.x * j.y).abs() + (r.y * j.x).abs();
        let after = body.spin().to_f64();
        let allowed = (0.5 + remainder) * C::S::unit(change)
            + C::S::SUM_OF_PRODUCTS * products * inverse
            + C::S::sum(after);
        let error = (after - start.spin().to_f64() - change).abs();
        spins.push(error / (C::S::REFERENCE * allowed + 2e-7 * C::S::unit(0.0)));
    }
    report::<C::S>(&format!("{what} velocity"), &velocities);
    report::<C::S>(&format!("{what} spin"), &spins);
}

#[test]
fn an_impulse_off_the_centre_is_exact_to_rounding() {
    // A unit of a remainder; what a float carries is not seen after one impulse.
    const FINE: f64 = 1.0 / 32768.0;
    check_impulses::<Point<I16F16>>("Point", 0.0);
    check_impulses::<Point<I8F24>>("Point", 0.0);
    check_impulses::<Point<f32>>("Point", 0.0);
    check_impulses::<Point<f64>>("Point", 0.0);
    check_impulses::<Carried<I16F16>>("Carried", FINE);
    check_impulses::<Carried<I8F24>>("Carried", FINE);
    check_impulses::<Carried<f32>>("Carried", 0.0);
    check_impulses::<Carried<f64>>("Carried", 0.0);
}

/// A box of 2 kg, 1.5 m by 0.5 m, hit on its corner: `I = m (w² + h²) / 12 = 0.41666667`,
/// `r×J = 0.75 * 3 + 0.25 * 1 = 2.5`. An inverse mass of 1/2 is exact; 1 / 2πI and the inertia as it is given are
/// off by less than 2^-30 each, of 0.95 turns/s.
fn check_box<C: Middle>() {
    let centre = Point::new(vec2(3, -2).unwrap(), vec2(1, 0).unwrap(), 2).unwrap();
    let mut body = Rigid::new(C::from(centre), dec!(0.4166666667)).unwrap();
    let corner = vec2(dec!(3.75), dec!(-2.25)).unwrap();
    body.push_at(corner, vec2(1, 3).unwrap());
    assert_eq!(body.velocity(), vec2(dec!(1.5), dec!(1.5)).unwrap());
    let exact = 2.5 / (std::f64::consts::TAU * 5.0 / 12.0);
    let error = (body.spin().to_f64() - exact).abs();
    let allowed = 0.51 * C::S::unit(1.0) + 2.0 * exact * (C::S::COEFFICIENT + 1e-10);
    assert!(error <= allowed, "{}: {error:e}", C::S::name());
    println!(
        "{} a box, hit on its corner: {error:.1e} turns/s off",
        C::S::name()
    );
}

#[test]
fn a_box_that_is_hit_on_its_corner() {
    check_box::<Point<I16F16>>();
    check_box::<Point<I8F24>>();
    check_box::<Point<f32>>();
    check_box::<Carried<I16F16>>();
    check_box::<Carried<f32>>();
}

/// `r×J` of an arm along the impulse is a difference of two equal products.
fn check_central<C: Middle>() {
    let mut draw = Draw(Random(2));
    for _ in 0..1000 {
        let mut body = draw.body::<C>();
        let (start, impulse) = (body, draw.vector::<C::S>(2.0));
        body.push(impulse);
        body.push_at(body.position(), impulse);
        body.push_off(impulse, impulse);
        body.push_off(-impulse - impulse, impulse);
        assert_eq!(body.spin(), start.spin());
        // With its remainder.
        assert_eq!(body.spin_momentum(), start.spin_momentum());
        assert_ne!(body.velocity(), start.velocity());
    }
}

#[test]
fn an_impulse_through_the_centre_turns_nothing() {
    check_central::<Point<I16F16>>();
    check_central::<Point<f32>>();
    check_central::<Point<f64>>();
    check_central::<Carried<I8F24>>();
    check_central::<Carried<f32>>();
}
