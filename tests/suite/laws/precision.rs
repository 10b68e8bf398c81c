//! How near a factor is to the ratio it stands for, and what gains sum to.

use fixstep::scalar::Factor;
use fixstep::{Ratio, Scalar};

use crate::laws::integer::Integer;
use crate::laws::judge::{Dyadic, Judge, Random, odd, ratio};

/// A ratio of two numbers below `2^31`, within `2^-spread` and `2^spread`.
fn some_ratio(random: &mut Random, spread: u64) -> Ratio {
    let any = random.next();
    let (num, den) = (any & 0x7FFF_FFFF | 1 << 30, any >> 33 | 1 << 30);
    match random.next() % (2 * spread + 1) {
        up if up > spread => ratio(num as i64, den >> (up - spread)),
        down => ratio((num >> down) as i64, den),
    }
}

/// `|represented - exact| <= exact / 2^bits`, in integers.
#[track_caller]
fn is_within(represented: Dyadic, exact: Ratio, bits: u32) {
    let (num, den) = (i128::from(exact.num()), i128::from(exact.den()));
    let exact = num << represented.shift;
    let error = represented.mantissa * den - exact;
    assert!(
        error.abs() <= exact.abs() >> bits,
        "{num}/{den}: {represented:?} is off by more than 2^-{bits}"
    );
}

/// Factors between `1/1000` and `1000`, relative error `2^-bits`.
pub fn relative<F: Factor<S>, S: Scalar, J: Judge<S>>(bits: u32, count: u64) {
    let mut random = Random(count);
    for _ in 0..count {
        let ratio = some_ratio(&mut random, 9);
        is_within(J::represented(F::new(ratio).unwrap()), ratio, bits);
    }
}

/// Lengths of time from a microsecond to a quarter second, relative error `2^-30 = 9.4e-10`.
pub fn spans<S: Scalar, J: Judge<S>>(count: u64) {
    let mut random = Random(count);
    for _ in 0..count {
        let seconds = some_ratio(&mut random, 9);
        let seconds = ratio(seconds.num(), seconds.den() << 12);
        is_within(J::represented(S::Span::new(seconds).unwrap()), seconds, 30);
    }
}

/// Relative error `2^-31`, and what an `f64` loses.
pub fn products<S: Scalar>(count: u64) {
    let mut random = Random(count);
    for _ in 0..count {
        let [a, b] = [(); 2].map(|_| S::Coef::new(some_ratio(&mut random, 9)).unwrap());
        let (product, exact) = (S::product(a, b).to_f64(), a.to_f64() * b.to_f64());
        assert!(
            (product - exact).abs() <= exact * (2.0_f64.powi(-31) + 2.0_f64.powi(-51)),
            "{a:?} {b:?}"
        );
    }
}

/// `|sum of gained over ticks 0..n - n h g| <= 1/2 + n / 2^32` in units of the last place, at
/// every n.
pub fn gains_sum<S: Integer, J: Judge<S>>(ticks: u64) {
    for (num, den) in [(1, 60), (1, 64), (1, 7), (4389, 262_144), (1, 1000)] {
        let h = S::Coef::new(ratio(num, den)).unwrap();
        let exact = J::represented(h);
        for raw in [0, 1, -1, 29, -642_908, 1_000_003, -(1 << 30), (1 << 31) - 1] {
            let gain = S::of_raw(raw).gain(h);
            let mut sum = 0;
            for n in 0..ticks {
                is_sum(sum, n, raw, exact);
                sum += S::gained(gain, n).raw();
            }
        }
    }
}

#[track_caller]
fn is_sum(sum: i128, n: u64, raw: i128, h: Dyadic) {
    let n = i128::from(n);
    let error = (sum << h.shift) - n * raw * h.mantissa;
    let allowed = (1 << h.shift) / 2 + (n << h.shift >> 32);
    assert!(
        error.abs() <= allowed,
        "{raw} after {n} ticks of {h:?} came to {sum}"
    );
}

/// A gain may be larger than the scalar: then it saturates.
pub fn gains_are_odd<S: Integer, J: Judge<S>>(count: u64) {
    let steps =
        [(1, 60), (1, 64), (1_000_001, 7)].map(|(num, den)| S::Coef::new(ratio(num, den)).unwrap());
    let check = |a: S, tick| {
        steps
            .iter()
            .for_each(|&h| odd::<S, J>(a, |a| S::gained(a.gain(h), tick)))
    };
    let mut random = Random(count);
    for _ in 0..count {
        check(J::any(random.next()), random.next());
    }
    J::corners()
        .into_iter()
        .for_each(|a| check(a, random.next()));
}

/// Starting at a tick where the counter of the fraction comes round changes nothing.
pub fn gains_from_any_tick<S: Integer>() {
    let h = S::Coef::new(ratio(1, 60)).unwrap();
    let gain = S::of_raw(-642_908).gain(h);
    for start in [1, 59, (1 << 32) - 30, u64::MAX - 100] {
        let sum: i128 = (0..60).map(|n| S::gained(gain, start + n).raw()).sum();
        assert!((sum + 642_908).abs() <= 1, "from tick {start}: {sum}");
    }
}
