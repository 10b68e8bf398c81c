//! The exact motion of a damped spring through one step, in integers.
//!
//! ```text
//! y' = P y,  y = (x, v/ω),  P = C + S N      N = ((ζ, 1), (-1, -ζ)),  N² = ζ² - 1
//! C  = exp(-ζ q) cos(q sqrt(1 - ζ²))         q = ω h
//! S  = exp(-ζ q) sin(q sqrt(1 - ζ²)) / sqrt(1 - ζ²)
//! P² = (C² - S² + ζ² S²) + 2 C S N
//! ```
//!
//! q is halved until series of a few terms are exact, and the result is squared as often. One formula
//! holds below, at and above critical damping. It needs no root, no trigonometry and no float. Numbers have 60
//! fractional bits, and each squaring costs one. A spring of one period a step keeps 54.
//! A spring of 10^9 periods a step keeps none of its phase.
//! Source: the solution of `x'' = -ω² x - 2 ζ ω x'`; scaling and squaring as Higham, "Functions of
//! Matrices" (2008), 10.3, has it.

use core::num::NonZero;

use crate::ratio::Ratio;

/// Bits behind the point.
const FRACTION: u32 = 60;
const ONE: i64 = 1 << FRACTION;
/// `2 π`.
const TURN: i64 = 0x6487_ED51_10B4_611A;
/// `1 / (2 π)`.
const INVERSE_TURN: i64 = 0x028B_E60D_B939_1055;

/// `1 / n!`.
const TERMS: [i64; 19] = {
    let (mut terms, mut n, mut product) = ([ONE; 19], 1, 1_i64);
    while n < 19 {
        product *= n as i64;
        terms[n] = (2 * ONE / product + 1) / 2;
        n += 1;
    }
    terms
};

/// What one step of an oscillator does.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Oscillation {
    c: i64,
    s: i64,
    /// `ζ S`.
    t: i64,
    hertz: Ratio,
}

/// `a * b`, rounded. A call, as all that is below: a product of 128 bits is long on a small core, and
/// this is done once.
#[inline(never)]
fn times(a: i64, b: i64) -> i64 {
    ((a as i128 * b as i128 + (1 << (FRACTION - 1))) >> FRACTION) as i64
}

/// `num / den`, a call for the same reason.
#[inline(never)]
fn quotient(num: u128, den: u128) -> u128 {
    NonZero::new(den).map_or(0, |den| num / den)
}

/// `sum(x^n terms[n])`, from the smallest.
fn series<'a>(x: i64, terms: impl DoubleEndedIterator<Item = &'a i64>) -> i64 {
    terms.rev().fold(0, |sum, &term| term + times(x, sum))
}

/// `value * ratio` for a value of 60 fractional bits.
#[inline(never)]
fn scaled(value: i64, num: u64, den: u64) -> Option<Ratio> {
    let magnitude = value.unsigned_abs() as u128 * num as u128;
    let ratio = Ratio::nearest(magnitude, (den as u128) << FRACTION)?;
    let sign = if value < 0 { -1 } else { 1 };
    Ratio::new(sign * ratio.num(), ratio.den()).ok()
}

impl Oscillation {
    /// One step of `seconds` at `hertz`, both greater than zero, with a damping ratio that is not
    /// negative; `None` beyond what 60 bits can tell.
    pub(crate) fn new(hertz: Ratio, damping_ratio: Ratio, seconds: Ratio) -> Option<Self> {
        let turns = hertz.over(seconds.inverse()?)?;
        // 2 π turns max(1, ζ) / 2^halvings <= 1/2, as 2 π < 2^3.
        let above = turns.exponent_above() + damping_ratio.exponent_above().max(0);
        let halvings = (above + 4).max(0) as u32;
        let shift = FRACTION.checked_sub(halvings)?;
        let turns = quotient((turns.num() as u128) << shift, turns.den().into());
        let q = times(i64::try_from(turns).ok()?, TURN);
        let damped = |value: i64| {
            let product = value as u128 * damping_ratio.num() as u128;
            quotient(product, damping_ratio.den().into()) as i64
        };
        let a = damped(q);
        let z = times(a, a) - times(q, q);
        let fades = series(-a, TERMS.iter());
        let c = times(fades, series(z, TERMS.iter().step_by(2)));
        let s = times(times(fades, q), series(z, TERMS.iter().skip(1).step_by(2)));
        let start = Oscillation {
            c,
            s,
            t: damped(s),
            hertz,
        };
        Some((0..halvings).fold(start, |half, _| half.twice()))
    }

    /// This step and another of the same length.
    fn twice(self) -> Self {
        let Oscillation { c, s, t, hertz } = self;
        Oscillation {
            c: times(c, c) - times(s, s) + times(t, t),
            s: 2 * times(c, s),
            t: 2 * times(c, t),
            hertz,
        }
    }

    /// What the position gains of the displacement, and the velocity of itself: `P - 1`.
    pub(crate) fn gains(self) -> Option<[Ratio; 2]> {
        let of = |value| Ratio::new(value, ONE as u64).ok();
        Some([of(self.c - ONE + self.t)?, of(self.c - ONE - self.t)?])
    }

    /// What the position gains of the velocity, s, and the velocity of the displacement, 1/s.
    pub(crate) fn exchanges(self) -> Option<[Ratio; 2]> {
        let (num, den) = (self.hertz.num() as u64, self.hertz.den());
        let forth = scaled(times(self.s, INVERSE_TURN), den, num)?;
        Some([forth, scaled(-times(self.s, TURN), num, den)?])
    }

    /// Without damping the step is a rotation by θ: `x += α v; v += β x; x += α v` with `α = tan(θ/2) / ω`
    /// and `β = -ω sin θ`, after a rotation by half a turn where cos θ is negative.
    pub(crate) fn shears(self) -> Option<(bool, [Ratio; 2])> {
        let over = self.c < 0;
        let turned = match over {
            true => Oscillation {
                c: -self.c,
                s: -self.s,
                ..self
            },
            false => self,
        };
        let sine = (turned.s.unsigned_abs() as u128) << FRACTION;
        let tangent = quotient(sine, ONE as u128 + turned.c as u128) as i64 * turned.s.signum();
        let (num, den) = (self.hertz.num() as u64, self.hertz.den());
        let half = scaled(times(tangent, INVERSE_TURN), den, num)?;
        Some((over, [half, scaled(-times(turned.s, TURN), num, den)?]))
    }
}

/// `1 / ω²`, s²: how far a spring sags by an acceleration of 1 m/s².
pub(crate) fn sag(hertz: Ratio) -> Option<Ratio> {
    let (num, den) = (hertz.num() as u64, hertz.den());
    let once = scaled(times(INVERSE_TURN, INVERSE_TURN), den, num)?;
    once.over(hertz)
}
