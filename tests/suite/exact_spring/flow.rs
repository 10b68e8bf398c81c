//! The reference: numbers of two `f64`, 106 bits, and in them the exact flow of a damped spring.
//!
//! ```text
//! y' = A y,  y = (x, v/ω),  A = ω ((0, 1), (-1, -2 ζ))       P(h) = exp(A h)
//! ```
//!
//! In these coordinates `|P| <= 1`: the energy of a spring does not grow. Sums and products are off by a
//! few 2^-104; the nine squarings at most double that each, so P is off by less than 1e-27.
//! Source of the arithmetic: Dekker, "A floating-point technique for extending the available
//! precision", Numer. Math. 18 (1971).

use std::array::from_fn;
use std::ops::{Add, Div, Mul, Neg, Sub};

use fixstep::Ratio;

/// The unevaluated sum of two numbers, the second below half a unit of the first.
#[derive(Clone, Copy, Debug)]
pub struct Double(pub f64, pub f64);

/// `2 π` to 106 bits: the `f64`, and sin of it taken back.
pub const TURN: Double = Double(std::f64::consts::TAU, 2.449_293_598_294_706_4e-16);

fn sum(a: f64, b: f64) -> Double {
    let high = a + b;
    let part = high - a;
    Double(high, (a - (high - part)) + (b - part))
}

impl Double {
    pub fn of(value: f64) -> Double {
        Double(value, 0.0)
    }

    pub fn ratio(ratio: Ratio) -> Double {
        let whole = |whole: i128| {
            let high = whole as f64;
            sum(high, (whole - high as i128) as f64)
        };
        whole(ratio.num().into()) / whole(ratio.den().into())
    }

    pub fn to_f64(self) -> f64 {
        self.0 + self.1
    }
}

impl Add for Double {
    type Output = Double;

    fn add(self, other: Double) -> Double {
        let (high, low) = (sum(self.0, other.0), sum(self.1, other.1));
        let high = sum(high.0, high.1 + low.0);
        sum(high.0, high.1 + low.1)
    }
}

impl Neg for Double {
    type Output = Double;

    fn neg(self) -> Double {
        Double(-self.0, -self.1)
    }
}

impl Sub for Double {
    type Output = Double;

    fn sub(self, other: Double) -> Double {
        self + -other
    }
}

impl Mul for Double {
    type Output = Double;

    fn mul(self, other: Double) -> Double {
        let high = self.0 * other.0;
        let low = self.0.mul_add(other.0, -high);
        sum(high, low + (self.0 * other.1 + self.1 * other.0))
    }
}

// Three digits of a long division: each takes 53 bits of what is left.
impl Div for Double {
    type Output = Double;

    fn div(self, other: Double) -> Double {
        let (mut rest, mut quotient) = (self, Double::of(0.0));
        for _ in 0..3 {
            let digit = Double::of(rest.0 / other.0);
            (rest, quotient) = (rest - digit * other, quotient + digit);
        }
        quotient
    }
}

/// A matrix over (x, v/ω).
#[derive(Clone, Copy, Debug)]
pub struct Matrix(pub [[Double; 2]; 2]);

impl Matrix {
    pub fn each(f: impl Fn(usize, usize) -> Double) -> Matrix {
        Matrix(from_fn(|i| from_fn(|k| f(i, k))))
    }

    pub fn identity() -> Matrix {
        Matrix::each(|i, k| Double::of((i == k) as u8 as f64))
    }

    pub fn times(&self, other: &Matrix) -> Matrix {
        let (a, b) = (&self.0, &other.0);
        Matrix::each(|i, k| a[i][0] * b[0][k] + a[i][1] * b[1][k])
    }

    pub fn of(&self, y: [Double; 2]) -> [Double; 2] {
        from_fn(|i| self.0[i][0] * y[0] + self.0[i][1] * y[1])
    }

    pub fn less(&self, other: &Matrix) -> Matrix {
        Matrix::each(|i, k| self.0[i][k] - other.0[i][k])
    }

    pub fn trace(&self) -> Double {
        self.0[0][0] + self.0[1][1]
    }

    pub fn determinant(&self) -> Double {
        self.0[0][0] * self.0[1][1] - self.0[0][1] * self.0[1][0]
    }

    pub fn inverse(&self) -> Matrix {
        let ([[a, b], [c, d]], by) = (self.0, self.determinant());
        Matrix([[d / by, -b / by], [-c / by, a / by]])
    }

    pub fn to_f64(self) -> [[f64; 2]; 2] {
        self.0.map(|row| row.map(Double::to_f64))
    }
}

/// `exp(A h)` for q = ω h: its series at q / 2^k, where 24 terms are exact, squared k times.
pub fn flow(q: Double, damping_ratio: Double) -> Matrix {
    let (mut halvings, mut part) = (0, q);
    while part.0 * (1.0 + 2.0 * damping_ratio.0) > 0.25 {
        (halvings, part) = (halvings + 1, part * Double::of(0.5));
    }
    let zero = Double::of(0.0);
    let generator = Matrix([[zero, part], [-part, -(part + part) * damping_ratio]]);
    let mut series = Matrix::identity();
    for n in (1..=24).rev() {
        let next = generator.times(&series);
        let one = Matrix::identity().0;
        series = Matrix::each(|i, k| one[i][k] + next.0[i][k] / Double::of(n as f64));
    }
    (0..halvings).fold(series, |half, _| half.times(&half))
}

/// ω, and the flow of a step of `seconds`.
pub fn step_of(hertz: Ratio, damping_ratio: Ratio, seconds: Ratio) -> (Double, Matrix) {
    let omega = TURN * Double::ratio(hertz);
    let q = omega * Double::ratio(seconds);
    (omega, flow(q, Double::ratio(damping_ratio)))
}

/// The closed forms below, at and above critical damping, in `f64`: a few units of 1, times the
/// condition q of the cosine.
#[test]
fn the_reference_is_the_exact_solution() {
    for q in [0.1_f64, 1.0, 2.5, 6.0] {
        for zeta in [0.0_f64, 0.5, 1.0, 2.0] {
            let rate = (1.0 - zeta * zeta).abs().sqrt();
            let (c, s) = if zeta < 1.0 {
                ((q * rate).cos(), (q * rate).sin() / rate)
            } else if zeta > 1.0 {
                ((q * rate).cosh(), (q * rate).sinh() / rate)
            } else {
                (1.0, q)
            };
            let fades = (-zeta * q).exp();
            let exact = [
                [fades * (c + zeta * s), fades * s],
                [-fades * s, fades * (c - zeta * s)],
            ];
            let [row, other] = flow(Double::of(q), Double::of(zeta)).to_f64();
            let pairs = row.iter().chain(&other).zip(exact.as_flattened());
            for (entry, exact) in pairs {
                assert!((entry - exact).abs() <= 4e-16 * (4.0 + q), "{q} {zeta}");
            }
        }
    }
}
