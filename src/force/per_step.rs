//! What forces keep: coefficients, and their products with `h`.

use crate::error::Error;
use crate::ratio::Ratio;
use crate::scalar::{Factor, Scalar};
use crate::time::TimeStep;

/// The coefficient of a force: neither negative, nor out of range, nor lost to rounding.
///
/// For forces of your own; `field` names the argument in the error.
///
/// ```
/// use fixstep::{Error, dec, force::coefficient};
/// assert_eq!(coefficient::<f32>("drag", dec!(0.5)), Ok(0.5));
/// let (field, value) = ("drag", dec!(-1));
/// assert_eq!(coefficient::<f32>(field, value), Err(Error::Negative { field, value }));
/// ```
#[inline(always)]
pub fn coefficient<S: Scalar>(field: &'static str, value: Ratio) -> Result<S::Coef, Error> {
    if value.num() < 0 {
        return Err(Error::Negative { field, value });
    }
    S::Coef::new(value).ok_or(match value.num() as u64 > value.den() {
        true => Error::OutOfRange { field, value },
        false => Error::RoundsToZero { field, value },
    })
}

/// Half of a coefficient, for what is done in two halves of a step.
///
/// ```
/// use fixstep::force::half;
/// assert_eq!(half::<f32>(3.0), 1.5);
/// ```
#[inline]
#[must_use]
pub fn half<S: Scalar>(whole: S::Coef) -> S::Coef {
    match Ratio::new(1, 2).ok().and_then(S::Coef::new) {
        Some(half) => S::product(whole, half),
        None => whole,
    }
}

/// Whether a [`coefficient`] is zero.
pub(super) fn is_none<S: Scalar>(coefficient: S::Coef) -> bool {
    S::Coef::new(Ratio::whole(0)) == Some(coefficient)
}

/// Coefficients multiplied with `h`: made anew when the step changes, not in every step.
///
/// For forces of your own: keep one, and ask it in `prepare` or `couple`.
///
/// ```
/// use fixstep::{Step, force::PerStep};
/// let mut drag = PerStep::<f32, f32>::new();
/// let step = Step::hz(50)?;
/// let (mut made, k) = (0, 2.0);
/// for _ in 0..100 {
///     let kh = drag.get(&step, |h| { made += 1; k * h });
///     assert!((kh - 0.04).abs() < 1e-8);
/// }
/// assert_eq!(made, 1); // once for a length of step
/// # Ok::<(), fixstep::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct PerStep<S: Scalar, T>(Option<(S::Coef, T)>);

impl<S: Scalar, T: Copy> Default for PerStep<S, T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<S: Scalar, T: Copy> PerStep<S, T> {
    /// Nothing made yet.
    #[must_use]
    pub const fn new() -> Self {
        PerStep(None)
    }

    /// What `make` makes of `h`, remembered for as long as `h` is the same.
    #[inline]
    pub fn get(&mut self, step: &impl TimeStep<S>, make: impl FnOnce(S::Coef) -> T) -> T {
        let h = step.coef();
        match self.0 {
            Some((made_for, value)) if made_for == h => value,
            _ => *self.renew(h, make),
        }
    }

    // As `Memo`, which it does not use: a layer more costs a scene of gravity 28 bytes of flash on M0+.
    #[cold]
    #[inline(never)]
    fn renew(&mut self, h: S::Coef, make: impl FnOnce(S::Coef) -> T) -> &T {
        &self.0.insert((h, make(h))).1
    }
}
