//! Number types, and the laws that each of them keeps.
//!
//! | law | meaning |
//! |---|---|
//! | total | no operation panics or wraps, in debug or in release; fixed point saturates, floats go to infinity or NaN |
//! | odd | `(-a) op b == -(a op b)` for every `a` but the most negative, so a mirrored scene gives the mirrored result; only a sum that saturates ends at the type's own limits, the lower one unit further |
//! | nearest | a product is rounded once, to the nearest value; ties go away from zero in fixed point, to even in floats |
//! | own precision | `h`, `k` and `1/m` are not state: they are kept with more relative precision than the state has |
//! | same bits | the same inputs give the same bits on every target |
//!
//! Implemented for `f32`, `f64`, every [`FixedI32`](crate::fixed::FixedI32) but `I0F32` and `I32F0`, and, as
//! a wide reference, every such [`FixedI64`](crate::fixed::FixedI64). You can implement the trait
//! for a number type of your own.
//!
//! **Warning.** On an `I8F24`, `a * b` is the operator of the crate `fixed`. It floors. On overflow it
//! panics in debug builds and wraps in release builds. The methods here (`plus`, `times`, ...) and the
//! operators of [`Vec2`](crate::Vec2) keep the laws.
//!
//! ```
//! use fixstep::{Scalar, fixed::types::I8F24};
//! let a = I8F24::lit("100");
//! assert_eq!(a.plus(a), I8F24::MAX); // saturates
//! assert_eq!(100.0_f32.plus(100.0), 200.0);
//! ```

mod angular;
mod carry;
mod decay;
mod factor;
mod fixed;
mod float;
mod gain;
mod integer;
mod rational;
mod stored;

use core::fmt::Debug;

use crate::ratio::Ratio;

pub(crate) use integer::{Word, divide_words};

pub use angular::{Angular, CarryAngular, Turns};
pub use carry::Carry;
pub use decay::Decay;
pub use factor::{Coef, InvMass, Span};
pub use gain::Gain;
pub use rational::Rational;
pub use stored::Stored;

/// A number that multiplies a scalar. It has its own precision, and each product is rounded once.
///
/// ```
/// use fixstep::{Scalar, dec, fixed::types::I16F16, scalar::Factor};
/// let half: <I16F16 as Scalar>::Coef = Factor::<I16F16>::new(dec!(0.5)).unwrap();
/// assert_eq!(half.scale(I16F16::lit("3")), 1.5);
/// ```
pub trait Factor<S>: Copy + Debug + PartialEq + 'static {
    /// The factor nearest to `ratio`; `None` if it is out of range or would become zero.
    /// Zero itself is allowed where the factor may be zero.
    #[must_use]
    fn new(ratio: Ratio) -> Option<Self>;

    /// `self * value`: nearest, odd, saturating.
    #[must_use]
    fn scale(self, value: S) -> S;

    /// The factor as it is represented, for reports and references.
    #[must_use]
    fn to_f64(self) -> f64;
}

/// A number type whose sums lose no bit. Where `a.plus(b)` is [inside](Scalar::is_inside), subtracting
/// `b` gives `a` again, in any order of several sums. Fixed point is exact; a float rounds its sums.
///
/// ```
/// use fixstep::{Exact, Scalar, fixed::types::I16F16};
/// fn comes_back<S: Exact>(a: S, b: S) -> bool {
///     a.plus(b).minus(b) == a
/// }
/// assert!(comes_back(I16F16::lit("0.1"), I16F16::lit("1000")));
/// assert!(0.1_f32.plus(1000.0).minus(1000.0) != 0.1);
/// ```
#[diagnostic::on_unimplemented(
    message = "a world in `{Self}` cannot go back: its sums round",
    note = "sums of fixed point lose nothing"
)]
pub trait Exact: Scalar {}

/// A number type that a scene can be written in. The [module](self) states its laws.
///
/// ```
/// use fixstep::{dec, Scalar, fixed::types::I16F16};
/// let a = I16F16::ratio(dec!(1.5)).unwrap();
/// assert_eq!(a.plus(I16F16::MAX), I16F16::MAX);
/// assert_eq!(a.times(a), 2.25);
/// ```
pub trait Scalar: Copy + PartialOrd + Debug + 'static {
    /// A coefficient: stiffness, drag, their products with `h`. May be zero or negative.
    type Coef: Factor<Self>;
    /// A *span* is a length of time below a quarter second, for the hot loop `x += h v`. Never zero.
    type Span: Factor<Self>;
    /// One over a mass. Never zero; no larger than the scalar.
    type InvMass: Factor<Self> + Into<Self::Coef>;
    /// A sum of two products, narrowed once.
    type Sum: Copy + Debug;
    /// What a constant rate adds in one step, finer than the scalar.
    type Gain: Copy + Debug;

    /// Zero.
    const ZERO: Self;

    /// The largest value.
    const MAX: Self;

    /// Coefficients below 2 to this power can be held; at most 62.
    const COEF_BITS: u32;

    /// A span just below `ratio` and one just above, used alternately. Floats have one only, twice.
    #[must_use]
    fn spans(ratio: Ratio) -> Option<[Self::Span; 2]> {
        let span = Self::Span::new(ratio)?;
        Some([span, span])
    }

    /// The value nearest to `ratio`, `None` outside `-MAX..=MAX`.
    #[must_use]
    fn ratio(ratio: Ratio) -> Option<Self>;

    /// `self + other`, saturating.
    #[must_use]
    fn plus(self, other: Self) -> Self;

    /// `self - other`, saturating.
    #[must_use]
    fn minus(self, other: Self) -> Self;

    /// `-self`, saturating.
    #[must_use]
    fn negated(self) -> Self;

    /// `self * other`: nearest, odd, saturating.
    #[must_use]
    fn times(self, other: Self) -> Self;

    /// `num / 2^shift * self`: nearest, odd, saturating; `num <= 2^30` and `1 <= shift <= 30`.
    /// Called with constants: a shift where `num` is 1.
    #[must_use]
    fn dyadic(self, num: u32, shift: u32) -> Self;

    /// `h * self` for [`gained`](Scalar::gained), with more fraction than the scalar has.
    #[must_use]
    fn gain(self, h: Self::Coef) -> Self::Gain;

    /// The part of a gain that is added at `tick`. The values of ticks `0..n` sum to n times the
    /// gain, rounded once. Floats return the gain itself.
    #[must_use]
    fn gained(gain: Self::Gain, tick: u64) -> Self;

    /// `a.x * b.x + a.y * b.y` in the wide type.
    #[must_use]
    fn dot(a: [Self; 2], b: [Self; 2]) -> Self::Sum;

    /// A wide sum as a scalar: nearest, odd, saturating.
    #[must_use]
    fn narrow(sum: Self::Sum) -> Self;

    /// `sum / self`: nearest, odd, saturating; zero where `self` is not greater than zero.
    #[must_use]
    fn quotient(sum: Self::Sum, divisor: Self) -> Self;

    /// `sqrt(v.x² + v.y²)`. Fixed point forms the squares in the wide type: nearest, saturating.
    /// Floats form them in their own: infinite from about 1e19 in `f32`.
    #[must_use]
    fn length(v: [Self; 2]) -> Self;

    /// `1 / sqrt(v.x² + v.y² + softening²)`, zero where all three are zero. Fixed point forms the
    /// squares in the wide type and keeps 30 bits of the result, however small it is.
    #[must_use]
    fn inverse_length(v: [Self; 2], softening: Self) -> Self::Coef;

    /// The same number as a coefficient, exactly: a factor that changes with the state.
    #[must_use]
    fn coef(self) -> Self::Coef;

    /// The mass, kg, nearest to one over its inverse.
    #[must_use]
    fn mass(inverse: Self::InvMass) -> Self::Coef;

    /// The product of two coefficients, saturating.
    #[must_use]
    fn product(a: Self::Coef, b: Self::Coef) -> Self::Coef;

    /// `loss * self`: what a decaying value loses, for a loss from 0 to 1. In fixed point it is at
    /// least one unit, unless the loss is zero, so that the value reaches zero.
    #[inline]
    #[must_use]
    fn lost(self, loss: Self::Coef) -> Self {
        loss.scale(self)
    }

    /// Whether the value is neither at an end of the range nor NaN nor infinite.
    #[must_use]
    fn is_inside(self) -> bool;

    /// The exact bits, equal for values that are equal: one NaN, one zero.
    #[must_use]
    fn bits(self) -> u64;

    /// The value, or the nearest `f64` to it. For reports; no step calls it.
    #[must_use]
    fn to_f64(self) -> f64;
}
