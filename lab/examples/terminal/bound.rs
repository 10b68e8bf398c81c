//! How far rounding can keep a body from its terminal speed.
//!
//! With v the speed, `p` the power of v in the drag and `q = g h / v_t`, every method makes
//!
//! ```text
//! v' = v + s(n) - q v^p / v_t^(p-1) - r       s(n): gravity's share of tick n; r: what rounding adds
//! ```
//!
//! so v_t is the fixed point: methods have no error of their own here. Let `e = v - v_t`.
//!
//! *Fixed point, unit u.* Drag's kick is rounded once, sums are exact: `|r| <= u/2`. The shares of n
//! ticks sum to `n g h` rounded once: `s(n) = g h + d(n+1) - d(n)` with `|d| <= u/2`. Then `f = e - d`
//! obeys, with `w = q` for p = 1, and `w = q (v + v_t) / v_t` for p = 2, which is `p q` near v_t,
//!
//! ```text
//! f' = (1 - w) f - w d - r        0 < w <= 1, hence |f| <= u/2 + u/(2 w)
//! |e| <= |f| + |d| <= u + u/(2 p q)
//! ```
//!
//! Relatively that is `u/v_t + u/(2 p g h)`: a dead zone that depends on neither m, k nor v_t.
//! Inside of it: while g h lies between the units a and a + 1, a kick of a lets v rise and one of
//! a + 1 lets it fall, so v hovers where the kick changes, at `p q e = (a + 1/2) u - g h`.
//!
//! *Floats.* The shares are all the same and `d = 0`, but both sums round: `|r| <= ulp(v + g h)`, and
//! `|e| <= ulp(v + g h) / (p q)`, relatively `ulp / (p g h)`: it grows with v_t.
//!
//! *Mean.* Summed over n ticks, `p q mean(e) = -mean(r) - (f(n) - f(0))/n`, but for
//! `q mean(e²)/v_t` if p = 2. With `n q = 20` and |e| below 1 % of v_t the two add 10 % of the dead
//! zone and u/20 at most.
//!
//! *Coefficients.* h is the same in both forces and cancels. Fixed point holds g to u/2, 1/m to
//! 2^-26, k and its three products to 2^-31 each: 2^-25 has room for those and for the cut of g h
//! at 2^-32 u. A float rounds g, g h, k, k h, 1/m, k h/m and drag's kick: 7; for p = 2 also v², its
//! root and the product with it: 10. An error of the drag is an error of v_t by 1/p.

use crate::fall::SETTLED;
use crate::scene::{Fall, Law};
use crate::support::Format;

/// Largest errors, relative to the terminal speed.
#[derive(Clone, Copy, Debug)]
pub struct Bound {
    pub mean: f64,
    pub worst: f64,
}

/// Room for products of two errors, while each is below 1 %.
const ROOM: f64 = 1.01;

pub fn bound<S: Format>(fall: &Fall) -> Bound {
    let (speed, power) = (fall.speed(), fall.law.power());
    let (dither, rounding) = if is_fixed::<S>() {
        (S::unit(0.0), S::unit(0.0) / 2.0)
    } else {
        (0.0, S::unit(ROOM * speed + fall.gain()))
    };
    let dead_zone = rounding / (power * fall.share());
    let elsewhere = coefficients::<S>(fall) + (-SETTLED).exp();
    let relative = |error| ROOM * error / speed + elsewhere;
    Bound {
        mean: relative(1.1 * dead_zone + dither / 20.0),
        worst: relative(dead_zone + dither),
    }
}

/// How far the terminal speed of the represented coefficients is from the exact one, relatively;
/// the latter is rounded four times itself.
pub fn coefficients<S: Format>(fall: &Fall) -> f64 {
    let error = if is_fixed::<S>() {
        S::unit(0.0) / 2.0 / fall.gravity + 2.0_f64.powi(-25)
    } else {
        let roundings = match fall.law {
            Law::Linear => 7.0,
            Law::Quadratic => 10.0,
        };
        roundings * S::unit(1.0) / 2.0
    };
    error / fall.law.power() + 2.0 * f64::EPSILON
}

/// Whether values are equally far apart everywhere.
pub fn is_fixed<S: Format>() -> bool {
    S::unit(1.0) == S::unit(2.0)
}
