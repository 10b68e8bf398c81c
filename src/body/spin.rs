//! The rotation of a body: none, or a spin.

use core::fmt::Debug;

use crate::scalar::Scalar;

/// The spin of a type of body: [`NoSpin`], or a scalar in turns/s.
///
/// Methods integrate spins as they integrate velocities. For [`NoSpin`] the compiler removes this code.
///
/// ```
/// use fixstep::body::Spin;
/// let spin = 0.5_f32; // turns/s
/// assert_eq!(spin.sum(0.25), 0.75);
/// assert_eq!(spin.half(), 0.25);
/// ```
pub trait Spin<S: Scalar>: Copy + Debug + PartialEq + 'static {
    /// No rotation.
    const NONE: Self;

    /// `self + other`, saturating.
    #[must_use]
    fn sum(self, other: Self) -> Self;

    /// `-self`.
    #[must_use]
    fn reversed(self) -> Self;

    /// `self / 2`, rounded.
    #[must_use]
    fn half(self) -> Self;

    /// `factor * self`, rounded.
    #[must_use]
    fn part(self, factor: S::Coef) -> Self;
}

/// The spin of a body that does not rotate. It takes no memory.
///
/// ```
/// use fixstep::body::{NoSpin, Spin};
/// assert_eq!(size_of::<NoSpin>(), 0);
/// assert_eq!(Spin::<f32>::sum(NoSpin, NoSpin), NoSpin);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct NoSpin;

impl<S: Scalar> Spin<S> for NoSpin {
    const NONE: NoSpin = NoSpin;

    #[inline(always)]
    fn sum(self, _other: NoSpin) -> NoSpin {
        NoSpin
    }

    #[inline(always)]
    fn reversed(self) -> NoSpin {
        NoSpin
    }

    #[inline(always)]
    fn half(self) -> NoSpin {
        NoSpin
    }

    #[inline(always)]
    fn part(self, _factor: S::Coef) -> NoSpin {
        NoSpin
    }
}

impl<S: Scalar> Spin<S> for S {
    const NONE: S = S::ZERO;

    #[inline]
    fn sum(self, other: S) -> S {
        self.plus(other)
    }

    #[inline]
    fn reversed(self) -> S {
        self.negated()
    }

    #[inline]
    fn half(self) -> S {
        self.dyadic(1, 1)
    }

    #[inline]
    fn part(self, factor: S::Coef) -> S {
        crate::scalar::Factor::scale(factor, self)
    }
}
