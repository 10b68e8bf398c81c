//! Quantities that advance at their own rate during a step.

use crate::scalar::Scalar;

/// A quantity that advances at its own rate, such as an angle with its spin.
///
/// ```
/// use fixstep::{DyadicStep, Scalar, TimeStep, time::Revolve};
/// struct Tank(f32); // litres; it fills at 3 litres a second
/// impl Revolve<f32> for Tank {
///     fn revolved(self, h: f32, halvings: u32) -> Tank { Tank(self.0 + 3.0 * h.dyadic(1, halvings)) }
///     fn revolved_dyadic(self, num: u32, shift: u32) -> Tank { Tank(self.0 + 3.0_f32.dyadic(num, shift)) }
/// }
/// let step = DyadicStep::<f32, 1, 2>::new()?; // 1/4 s
/// assert_eq!(step.revolve(Tank(1.0)).0, 1.75);
/// # Ok::<(), fixstep::Error>(())
/// ```
pub trait Revolve<S: Scalar> {
    /// Advances by `h / 2^halvings` times its rate; `halvings` is 0 or 1.
    #[must_use]
    fn revolved(self, h: S::Coef, halvings: u32) -> Self;

    /// Advances by `num / 2^shift` times its rate, as exactly as it can hold. Called with constants.
    #[must_use]
    fn revolved_dyadic(self, num: u32, shift: u32) -> Self;
}
