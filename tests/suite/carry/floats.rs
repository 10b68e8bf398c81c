//! Compensated sums of floats beside sums in twice the precision.

use fixstep::Carry;

use crate::support::*;

/// Terms of one sum.
const TERMS: usize = 20_000;

/// A sum of two `f64` without loss: Knuth's.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let part = sum - a;
    (sum, (a - (sum - part)) + (b - part))
}

/// A number of about 106 bits.
#[derive(Clone, Copy, Default)]
struct Wide(f64, f64);

impl Wide {
    fn plus(self, term: f64) -> Wide {
        let (sum, low) = two_sum(self.0, term);
        let (high, low) = two_sum(sum, low + self.1);
        Wide(high, low)
    }

    fn less(self, other: f64) -> f64 {
        let Wide(high, low) = self.plus(-other);
        high + low
    }
}

/// A float and the roundoff of one operation.
trait Real: Format + Carry<FinePosition = [Self; 2], Coef = Self> {
    const ROUNDOFF: f64;
}

impl Real for f32 {
    const ROUNDOFF: f64 = f32::EPSILON as f64 / 2.0;
}

impl Real for f64 {
    const ROUNDOFF: f64 = f64::EPSILON / 2.0;
}

/// Terms between -1 and 3, as a body that wanders and flies.
fn terms<S: Real>(start: usize) -> Vec<S> {
    let mut random = Random(start as u64 + 1);
    let unit = |word: u64| (word >> 11) as f64 / 2.0_f64.powi(53);
    (0..TERMS)
        .map(|_| scalar(4.0 * unit(random.next()) - 1.0))
        .collect()
}

fn exact<S: Real>(terms: &[S]) -> (Wide, f64) {
    let start = (Wide::default(), 0.0);
    terms.iter().fold(start, |(sum, all), term| {
        (sum.plus(term.to_f64()), all + term.to_f64().abs())
    })
}

/// Errors of a sum over the sum of all magnitudes, in units of roundoff: plain, compensated, and of
/// velocities, whose excess is kept to eight bits or sixteen.
fn errors<S: Real>(start: usize) -> [f64; 3] {
    let (terms, one) = (terms::<S>(start), scalar::<S>(1.0));
    let (sum, all) = exact(&terms);
    let plain = terms.iter().fold(S::ZERO, |sum, &term| sum.plus(term));
    let place = terms.iter().fold(S::ZERO.fine_position(), |place, &term| {
        S::moved(place, term, one, 0)
    });
    let start = (S::ZERO, S::NO_REMAINDER);
    let kept = terms
        .iter()
        .fold(start, |kept, &term| S::kicked(kept, term, one));
    let in_units = |error: f64| error.abs() / all / S::ROUNDOFF;
    let [high, excess] = place.map(S::to_f64);
    [
        in_units(sum.less(plain.to_f64())),
        in_units(sum.plus(excess).less(high)),
        in_units(sum.less(kept.0.to_f64())),
    ]
}

/// Kahan: with what is left over, two units of roundoff of the sum of all magnitudes. What a velocity
/// is seen as adds one of itself, which is less; its excess is rounded by `2^-9` or less of half a unit
/// a term, all one way at worst: `N 2^-9` units of the largest sum, of which a tenth at random.
fn check<S: Real>(short: f64) {
    let all: [[f64; 3]; 16] = std::array::from_fn(errors::<S>);
    let column = |k: usize| all.map(|row| row[k]);
    let name = S::name();
    println!(
        "{name} plain sum, roundoffs: median {:.1e}, max {:.1e}",
        median(&column(0)),
        maximum(&column(0))
    );
    within(2.1, &format!("{name} compensated, roundoffs"), &column(1));
    let bound = 3.1 + 0.5 * TERMS as f64 * short;
    within(bound, &format!("{name} velocity, roundoffs"), &column(2));
    assert!(10.0 * median(&column(1)) <= median(&column(0)));
    assert!(10.0 * median(&column(2)) <= median(&column(0)));
}

#[test]
fn sums_of_f32_lose_two_roundoffs_at_most() {
    check::<f32>(2.0_f64.powi(-9));
}

#[test]
fn sums_of_f64_lose_two_roundoffs_at_most() {
    check::<f64>(2.0_f64.powi(-21));
}

/// One and a half units of roundoff below one: one step is lost by a plain sum, a hundred by none.
#[test]
fn small_steps_are_not_lost() {
    let small = 0.375 * f32::EPSILON;
    let mut place = 1.0_f32.fine_position();
    let mut kept = (1.0_f32, f32::NO_REMAINDER);
    assert_eq!(1.0 + small, 1.0);
    for _ in 0..1000 {
        place = f32::moved(place, small, 1.0, 0);
        kept = f32::kicked(kept, small, 1.0);
    }
    assert_eq!(f32::seen(place), 1.0 + 375.0 * f32::EPSILON);
    assert_eq!(kept.0, 1.0 + 375.0 * f32::EPSILON);
}

/// A damped velocity follows `(1 - a)^n`: two roundoffs a step of what is left, which shrinks as well.
#[test]
fn a_damped_float_follows_its_decay() {
    for loss in [0.5_f32, 0.0123, 1e-4] {
        let mut kept = (7.25_f32, f32::NO_REMAINDER);
        let steps = (5.0 / loss) as i32;
        for _ in 0..steps {
            kept = f32::damped(kept, loss);
        }
        let exact = 7.25 * (1.0 - loss as f64).powi(steps);
        // Excess kept to 2^-9 of itself, and half a unit as seen; products are rounded to a roundoff
        // of `a v` each, 5 in all.
        let bound = exact * 2.0_f64.powi(-24) * (2.0 + 10.0 + steps as f64 * 2.0_f64.powi(-9));
        assert!((kept.0 as f64 - exact).abs() <= bound, "{loss}");
    }
}

#[test]
fn remainders_of_floats_come_back() {
    for bits in 0..=u16::MAX {
        assert_eq!(f32::from_remainder_bits(bits.into()), Some(bits));
        assert_eq!(f32::remainder_bits(bits), u64::from(bits));
    }
    assert_eq!(f32::from_remainder_bits(1 << 16), None);
    assert_eq!(f64::from_remainder_bits(1 << 32), None);
    assert_eq!(f32::from_halves([0, 1 << 32]), None);
    // One NaN, one zero.
    let nans = [0x7FC0, 0xFFC0, 0x7F81].map(f32::remainder_left_over);
    assert!(nans.iter().all(|&bits| bits == nans[0]));
    assert_eq!(
        f32::remainder_left_over(0x8000),
        f32::remainder_left_over(0)
    );
}

/// Exact in fixed point, and to the excess in floats: `v - excess` over `1/m`.
#[test]
fn momentum_of_a_float_has_its_remainder() {
    let kept = f32::kicked((1.0, f32::NO_REMAINDER), 0.25 * f32::EPSILON, 1.0);
    assert_eq!(kept.0, 1.0);
    assert_eq!(
        f32::momentum(kept, 0.5),
        2.0 * (1.0 + 0.25 * f32::EPSILON as f64)
    );
}
