//! What a body has of rotation: nothing, or a spin.

use core::fmt::Debug;

use crate::scalar::Scalar;

/// How a kind of body turns: [`NoSpin`], or a scalar in turns/s.
///
/// Methods work with spins as they work with velocities. Of what has no spin nothing is left when it
/// is compiled.
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

/// The spin of what does not turn. It takes no memory.
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
