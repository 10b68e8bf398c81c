//! The number law as a check that any implementer of `Scalar` can be put through.
//!
//! A [`Judge`] knows the exact result of each operation, by arithmetic that shares nothing with
//! the crate; the checks here compare and turn signs.

use std::fmt::Debug;

use fixstep::scalar::Factor;
use fixstep::{Ratio, Scalar};

/// A factor exactly as it is represented: `mantissa / 2^shift`.
#[derive(Clone, Copy, Debug)]
pub struct Dyadic {
    pub mantissa: i128,
    pub shift: u32,
}

/// What the results have to be.
pub trait Judge<S: Scalar> {
    /// The ends of the range, zero, and the values beside them.
    fn corners() -> Vec<S>;
    /// Some value, of any magnitude.
    fn any(bits: u64) -> S;
    /// Whether `-a` exists.
    fn has_negative(a: S) -> bool;
    fn is_inside(a: S) -> bool;
    fn sum(a: S, b: S) -> S;
    fn difference(a: S, b: S) -> S;
    fn product(a: S, b: S) -> S;
    fn scaled(factor: Dyadic, a: S) -> S;
    fn dot(a: [S; 2], b: [S; 2]) -> S;
    /// `a . b / divisor`
    fn quotient(a: [S; 2], b: [S; 2], divisor: S) -> S;
    fn is_length(v: [S; 2], length: S) -> bool;
    fn is_ratio(ratio: Ratio, value: Option<S>) -> bool;
    fn represented(factor: impl Factor<S>) -> Dyadic;
}

/// Equal bits; every NaN is one.
#[track_caller]
pub fn same<S: Scalar>(got: S, expected: S, of: impl Debug) {
    assert!(
        got.bits() == expected.bits(),
        "{of:?} gave {got:?}, not {expected:?}"
    );
}

/// A generator good enough to try many values: SplitMix64.
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (self.0 ^ self.0 >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ mixed >> 31
    }
}

pub fn ratio(num: i64, den: u64) -> Ratio {
    Ratio::new(num, den).unwrap()
}

/// A few factors of each kind with what they represent.
pub struct Factors<S: Scalar> {
    coefs: Vec<(S::Coef, Dyadic)>,
    spans: Vec<(S::Span, Dyadic)>,
    inv_masses: Vec<(S::InvMass, Dyadic)>,
}

impl<S: Scalar> Factors<S> {
    pub fn some<J: Judge<S>>() -> Factors<S> {
        Factors {
            coefs: represent::<S, J, _>(&[(0, 1), (1, 60), (-7, 3), (1, 1), (1, 2), (900, 1)]),
            spans: represent::<S, J, _>(&[(1, 60), (1, 120), (1, 64), (4389, 262_144)]),
            inv_masses: represent::<S, J, _>(&[(1, 1), (1, 3), (2, 1), (1, 900), (1000, 1)]),
        }
    }
}

fn represent<S: Scalar, J: Judge<S>, F: Factor<S>>(ratios: &[(i64, u64)]) -> Vec<(F, Dyadic)> {
    let factor = |&(num, den)| {
        let factor = F::new(ratio(num, den)).unwrap();
        (factor, J::represented(factor))
    };
    ratios.iter().map(factor).collect()
}

/// Numerator and shift of `Scalar::dyadic`: both kinds of step, their halves, the ends.
const DYADIC: [(u32, u32); 9] = [
    (1, 1),
    (1, 6),
    (1, 7),
    (1, 30),
    (3, 2),
    (4389, 18),
    (4389, 19),
    (1 << 30, 1),
    (1 << 30, 30),
];

/// Laws of one value.
pub fn value<S: Scalar, J: Judge<S>>(a: S, factors: &Factors<S>) {
    same(a.negated(), J::difference(S::ZERO, a), ("negated", a));
    assert_eq!(a.is_inside(), J::is_inside(a), "is_inside {a:?}");
    scaled::<S, J, _>(&factors.coefs, a);
    scaled::<S, J, _>(&factors.spans, a);
    scaled::<S, J, _>(&factors.inv_masses, a);
    for (num, shift) in DYADIC {
        let factor = Dyadic {
            mantissa: num.into(),
            shift,
        };
        same(
            a.dyadic(num, shift),
            J::scaled(factor, a),
            ("dyadic", a, num, shift),
        );
        odd::<S, J>(a, |a| a.dyadic(num, shift));
    }
}

fn scaled<S: Scalar, J: Judge<S>, F: Factor<S>>(factors: &[(F, Dyadic)], a: S) {
    for &(factor, represented) in factors {
        same(factor.scale(a), J::scaled(represented, a), (factor, a));
        odd::<S, J>(a, |a| factor.scale(a));
    }
}

/// `f(-a) == -f(a)`
#[track_caller]
pub fn odd<S: Scalar, J: Judge<S>>(a: S, f: impl Fn(S) -> S) {
    if J::has_negative(a) {
        same(f(a.negated()), f(a).negated(), ("odd", a));
    }
}

/// Two values: each result is the exact one, rounded once.
pub fn nearest<S: Scalar, J: Judge<S>>(a: S, b: S) {
    same(a.plus(b), J::sum(a, b), ("plus", a, b));
    same(a.minus(b), J::difference(a, b), ("minus", a, b));
    same(a.times(b), J::product(a, b), ("times", a, b));
    let dot = S::dot([a, b], [b, b]);
    same(S::narrow(dot), J::dot([a, b], [b, b]), ("dot", a, b));
    same(
        S::quotient(dot, a),
        J::quotient([a, b], [b, b], a),
        ("under", a, b),
    );
    let length = S::length([a, b]);
    assert!(
        J::is_length([a, b], length),
        "length {a:?} {b:?} gave {length:?}"
    );
}

/// Two values: the mirrored operands give the mirrored result.
pub fn mirrored<S: Scalar, J: Judge<S>>(a: S, b: S) {
    odd::<S, J>(a, |a| a.times(b));
    odd::<S, J>(b, |b| a.times(b));
    odd::<S, J>(b, |b| S::quotient(S::dot([a, S::ZERO], [b, S::ZERO]), a));
    odd::<S, J>(a, |a| S::narrow(S::dot([a, a], [b, S::ZERO])));
    if J::has_negative(a) && J::has_negative(b) {
        mirrored_sums(a, b);
        same(
            S::length([a.negated(), b.negated()]),
            S::length([a, b]),
            ("length", a, b),
        );
    }
}

/// The rails are not symmetric, so a sum that reaches one need not be.
fn mirrored_sums<S: Scalar>(a: S, b: S) {
    let (sum, difference) = (a.plus(b), a.minus(b));
    if sum.is_inside() {
        same(
            a.negated().plus(b.negated()),
            sum.negated(),
            ("odd plus", a, b),
        );
    }
    if difference.is_inside() {
        same(
            a.negated().minus(b.negated()),
            difference.negated(),
            ("odd minus", a, b),
        );
    }
}

/// All laws of two values.
pub fn pair<S: Scalar, J: Judge<S>>(a: S, b: S) {
    nearest::<S, J>(a, b);
    mirrored::<S, J>(a, b);
}

/// Every corner, alone and with every other.
pub fn corners<S: Scalar, J: Judge<S>>() {
    let factors = Factors::some::<J>();
    for a in J::corners() {
        value::<S, J>(a, &factors);
        J::corners().into_iter().for_each(|b| pair::<S, J>(a, b));
    }
}

/// `count` random pairs are rounded once; a tenth of them is mirrored too.
pub fn pairs<S: Scalar, J: Judge<S>>(count: u64) {
    let mut random = Random(count);
    for i in 0..count {
        let (a, b) = (J::any(random.next()), J::any(random.next()));
        nearest::<S, J>(a, b);
        if i % 10 == 0 {
            mirrored::<S, J>(a, b);
        }
    }
}

/// `count` random values through every factor.
pub fn values<S: Scalar, J: Judge<S>>(count: u64) {
    let factors = Factors::some::<J>();
    let mut random = Random(count);
    for _ in 0..count {
        value::<S, J>(J::any(random.next()), &factors);
    }
}

/// Ratios of every magnitude, rounded once; ones outside the range are refused.
pub fn ratios<S: Scalar, J: Judge<S>>(count: u64) {
    let check = |ratio: Ratio| {
        let value = S::ratio(ratio);
        assert!(J::is_ratio(ratio, value), "{ratio} gave {value:?}");
    };
    let mut random = Random(count);
    for _ in 0..count {
        let num = (random.next() as i64 >> 1) >> (random.next() % 62);
        let den = (random.next() >> 2 >> (random.next() % 62)).max(1);
        check(ratio(num, den));
    }
    for shift in 0..=62 {
        for near in -1..=1 {
            let power = ((1_i64 << shift) + near).min(1 << 62);
            [1, 2, 3]
                .into_iter()
                .for_each(|den| check(ratio(power, den)));
            [1, 2, 3]
                .into_iter()
                .for_each(|den| check(ratio(-power, den)));
            [1, -1, 3]
                .into_iter()
                .for_each(|num| check(ratio(num, power.max(1) as u64)));
        }
    }
}
