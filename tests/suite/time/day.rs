//! A day of ticks reads back exactly, and what comes after many days does too.
//!
//! ```text
//! elapsed = n h        n = elapsed / h
//! ```

use fixstep::{Point, World};

use super::*;

/// One picture of a Game Boy Advance: 4389 / 2^18 s.
type Frame<S> = DyadicStep<S, 4389, 18>;

const DAY: u64 = 86_400;

/// The tick that a time is, if it is a whole one: `elapsed / h` in integers.
fn back(elapsed: Ratio, seconds: Ratio) -> Option<u64> {
    let num = i128::from(elapsed.num()) * i128::from(seconds.den());
    let den = i128::from(elapsed.den()) * i128::from(seconds.num());
    (num % den == 0).then(|| u64::try_from(num / den).unwrap())
}

// 86,400 s are 5,160,437.5 pictures: every one of them, and the first of the next day.
#[test]
fn every_tick_of_a_day_reads_back_exactly() {
    let step = Frame::<I16F16>::new().unwrap();
    let mut world = World::<Point<I16F16>, 1>::new();
    let mut ticks = 0;
    loop {
        let elapsed = world.time(&step).elapsed().unwrap();
        let (num, den) = (i128::from(elapsed.num()), i128::from(elapsed.den()));
        assert_eq!(num << 18, i128::from(ticks) * 4389 * den);
        assert_eq!(back(elapsed, step.seconds()), Some(ticks));
        assert_eq!(world.tick(), ticks);
        if num > i128::from(DAY) * den {
            break;
        }
        world.step(&mut SemiImplicitEuler, &mut (), &step);
        ticks += 1;
    }
    assert_eq!(ticks, (DAY << 18) / 4389 + 1);
}

// The first tick whose numerator has 63 bits needs more than a ratio has; before it all are exact.
#[test]
fn ticks_beyond_32_bits_are_exact_up_to_62_bits_of_time() {
    let step = Frame::<f64>::new().unwrap();
    let last = (1_u64 << 62) / 4389 / 2;
    for tick in (1 << 32..last).step_by((1 << 37) - 3).chain([last]) {
        for tick in tick - 2..=tick {
            let elapsed = Now::start(&step, tick).time::<f64>().elapsed().unwrap();
            let (num, den) = (i128::from(elapsed.num()), i128::from(elapsed.den()));
            assert_eq!(num << 18, i128::from(tick) * 4389 * den);
            assert_eq!(back(elapsed, step.seconds()), Some(tick));
        }
    }
    let beyond = Now::start(&step, last + 1).time::<f64>();
    assert_eq!(beyond.elapsed(), None);
    assert_eq!(beyond.half_ticks(), 2 * (last + 1));
}

#[test]
fn the_count_of_half_ticks_neither_wraps_nor_rounds_up_to_2_to_the_63() {
    let step = Frame::<f64>::new().unwrap();
    for tick in (32..63).flat_map(|n| [(1 << n) - 1, 1 << n, (1_u64 << n) + 1]) {
        let half_ticks = |now: Now<_>| now.time::<f64>().half_ticks();
        assert_eq!(half_ticks(Now::start(&step, tick)), 2 * tick);
        assert_eq!(half_ticks(Now::middle(&step, tick)), 2 * tick + 1);
    }
    let last = (1_u64 << 63) - 1;
    assert_eq!(Now::start(&step, last).tick(), last);
    let time = Now::start(&step, last).time::<f64>();
    assert_eq!(time.half_ticks(), u64::MAX - 1);
}

/// Whether no `f64` is nearer to `num / 2^18` than `value`. Both are whole numbers of 2^-18: the
/// exact one is, and `value` has all its bits or is so large that its unit is larger.
fn is_nearest(value: f64, num: u128) -> bool {
    let scaled = value * (1 << 18) as f64;
    let unit = (scaled.next_up() - scaled).min(scaled - scaled.next_down());
    scaled.fract() == 0.0 && (scaled as u128).abs_diff(num) as f64 <= unit / 2.0
}

// 2^63 h has 76 bits; `f64` holds 53 of them.
#[test]
fn seconds_are_nearest_at_every_age() {
    let step = Frame::<f64>::new().unwrap();
    for tick in (0..63).flat_map(|n| [(1 << n) - 1, 1 << n, (1_u64 << n) + 12_345]) {
        let seconds = Now::start(&step, tick).time::<f64>().seconds::<f64>();
        let exact = u128::from(tick) * 4389;
        assert!(is_nearest(seconds, exact), "{seconds} s, tick {tick}");
    }
}

// In decimals numerator and denominator grow beyond 62 bits. The exact time is rounded to 53 bits
// three times, and so is the result once: 2 eps.
#[test]
fn seconds_of_a_decimal_step_are_right_at_every_age() {
    for length in [dec!(0.01666666666666667), dec!(0.016666667), dec!(0.016)] {
        let step = Step::<f64>::from_seconds(length).unwrap();
        for tick in (0..62).map(|n| (1_u64 << n) + 12_345) {
            let seconds = Now::start(&step, tick).time::<f64>().seconds::<f64>();
            let num = u128::from(tick) * length.num() as u128;
            let error = (seconds / (num as f64 / length.den() as f64) - 1.0).abs();
            assert!(error <= 2.0 * f64::EPSILON, "{length} s, tick {tick}");
        }
    }
}
