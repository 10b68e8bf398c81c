//! What goes on at a rate of its own while a step passes.

use crate::scalar::Scalar;

/// What goes on at a rate of its own: an angle with its spin.
pub trait Revolve<S: Scalar> {
    /// By `h / 2^halvings` times its rate; `halvings` is 0 or 1.
    #[must_use]
    fn revolved(self, h: S::Coef, halvings: u32) -> Self;

    /// By `num / 2^shift` times its rate, exactly as far as it can hold it; called with constants.
    #[must_use]
    fn revolved_dyadic(self, num: u32, shift: u32) -> Self;
}
