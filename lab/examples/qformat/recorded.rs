//! The number that takes notes: `f64`, with a note of every result and, if a grid is laid, its rounding.
//!
//! It implements the number law and so flies any scene. The trait tells what is rounded where, and
//! what has to fit: sums, products and lengths fit the type, squared lengths twice the type,
//! coefficients have 31 bits and a binary point of their own.

use fixstep::scalar::{Decay, Factor};
use fixstep::{Ratio, Scalar};

use crate::grid;
use crate::notes::{Role, note};

/// A number of a scene that is only looked at.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Recorded(pub f64);

/// A coefficient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rate(pub f64);

/// One over a mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inverse(pub f64);

/// A length of time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Length(f64);

/// Noted, as what it is.
fn as_a(role: Role, value: f64) -> Recorded {
    note(role, value);
    Recorded(grid::held(value))
}

/// Rounded, and noted as a product.
pub fn product(value: f64) -> Recorded {
    as_a(Role::Product, grid::product(value))
}

fn rate(value: f64) -> Rate {
    note(Role::Coefficient, value);
    Rate(grid::coefficient(value))
}

macro_rules! factor {
    ($factor:ident, $new:expr) => {
        impl Factor<Recorded> for $factor {
            fn new(ratio: Ratio) -> Option<Self> {
                let new: fn(f64) -> Option<f64> = $new;
                new(ratio.to_f64()).map($factor)
            }

            fn scale(self, value: Recorded) -> Recorded {
                product(self.0 * value.0)
            }

            fn to_f64(self) -> f64 {
                self.0
            }
        }
    };
}

/// Whether a 32-bit mantissa with its shift holds that: from `2^-32` on.
fn holds(value: f64) -> bool {
    let (least, limit) = ((-32.0_f64).exp2(), (30.0_f64).exp2());
    value == 0.0 || (least..limit).contains(&value.abs())
}

factor!(Rate, |value| {
    note(Role::Coefficient, value);
    holds(value).then(|| grid::coefficient(value))
});
factor!(Inverse, |value| {
    let (least, limit) = ((-21.0_f64).exp2(), (11.0_f64).exp2());
    (least..limit)
        .contains(&value)
        .then(|| grid::inverse_mass(value))
});
factor!(Length, |value| (value > 0.0).then_some(value));

impl From<Inverse> for Rate {
    fn from(inverse: Inverse) -> Rate {
        Rate(inverse.0)
    }
}

impl Scalar for Recorded {
    type Coef = Rate;
    type Span = Length;
    type InvMass = Inverse;
    type Sum = f64;
    type Gain = f64;

    const ZERO: Recorded = Recorded(0.0);
    const MAX: Recorded = Recorded(f64::MAX);
    const COEF_BITS: u32 = 30;

    fn spans(ratio: Ratio) -> Option<[Length; 2]> {
        (ratio.num() > 0).then(|| grid::spans(ratio.to_f64()).map(Length))
    }

    fn ratio(ratio: Ratio) -> Option<Recorded> {
        Some(as_a(Role::Constant, grid::constant(ratio.to_f64())))
    }

    fn plus(self, other: Recorded) -> Recorded {
        as_a(Role::Sum, self.0 + other.0)
    }

    fn minus(self, other: Recorded) -> Recorded {
        as_a(Role::Difference, self.0 - other.0)
    }

    fn negated(self) -> Recorded {
        Recorded(-self.0)
    }

    fn times(self, other: Recorded) -> Recorded {
        product(self.0 * other.0)
    }

    fn dyadic(self, num: u32, shift: u32) -> Recorded {
        product(self.0 * f64::from(num) / (1_u64 << shift) as f64)
    }

    fn gain(self, h: Rate) -> f64 {
        h.0 * self.0
    }

    fn gained(gain: f64, tick: u64) -> Recorded {
        as_a(Role::Product, grid::gained(gain, tick))
    }

    fn dot(a: [Recorded; 2], b: [Recorded; 2]) -> f64 {
        let sum = a[0].0 * b[0].0 + a[1].0 * b[1].0;
        note(Role::Square, sum);
        grid::held_wide(sum)
    }

    fn narrow(sum: f64) -> Recorded {
        product(sum)
    }

    fn quotient(sum: f64, divisor: Self) -> Recorded {
        if divisor.0 > 0.0 {
            product(sum / divisor.0)
        } else {
            Recorded::ZERO
        }
    }

    fn length(v: [Recorded; 2]) -> Recorded {
        let length = v[0].0.hypot(v[1].0);
        as_a(Role::Length, grid::product(length))
    }

    fn inverse_length(v: [Recorded; 2], softening: Recorded) -> Rate {
        let [x, y] = v.map(|part| part.0);
        let square = x * x + y * y + softening.0 * softening.0;
        if square == 0.0 {
            return Rate(0.0);
        }
        rate(1.0 / square.sqrt())
    }

    fn coef(self) -> Rate {
        Rate(self.0)
    }

    fn mass(inverse: Inverse) -> Rate {
        rate(1.0 / inverse.0)
    }

    fn product(a: Rate, b: Rate) -> Rate {
        rate(a.0 * b.0)
    }

    fn lost(self, loss: Rate) -> Recorded {
        as_a(Role::Product, grid::loss(loss.0 * self.0))
    }

    fn is_inside(self) -> bool {
        self.0.is_finite()
    }

    fn bits(self) -> u64 {
        self.0.to_bits()
    }

    fn to_f64(self) -> f64 {
        self.0
    }
}

impl Decay for Recorded {
    fn decay(x: Rate) -> [Rate; 3] {
        f64::decay(x.0).map(rate)
    }

    fn share(q: Rate) -> Rate {
        rate(f64::share(q.0))
    }
}
