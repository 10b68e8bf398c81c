//! What a clock cannot be made of, by name, and what it just can.

use fixstep::Error;

use super::*;

const LIMIT: u64 = 1 << 62;

fn refusal(counts_per_second: u32, seconds: Ratio, most: u32) -> Option<Error> {
    Accumulator::new(counts_per_second, seconds, most).err()
}

fn not_positive(field: &'static str, value: Ratio) -> Option<Error> {
    Some(Error::NotPositive { field, value })
}

#[test]
fn nothing_may_be_zero_and_no_step_negative() {
    let (step, zero) = (ratio(1, 60), Ratio::ZERO);
    assert_eq!(refusal(0, step, 4), not_positive("counts_per_second", zero));
    assert_eq!(refusal(1000, step, 0), not_positive("max_steps", zero));
    for seconds in [zero, ratio(-1, 60), ratio(-1, LIMIT), ratio(0, 7)] {
        assert_eq!(refusal(1000, seconds, 4), not_positive("seconds", seconds));
    }
    assert_eq!(refusal(1, step, 1), None);
    assert_eq!(refusal(u32::MAX, step, u32::MAX), None);
}

// One count is den / (num counts_per_second) of a step, in lowest terms.
#[test]
fn a_common_unit_beyond_62_bits_is_refused() {
    let most = LIMIT as i64;
    let refused = |counts_per_second, seconds| {
        let error = Error::OutOfRange {
            field: "seconds",
            value: seconds,
        };
        assert_eq!(refusal(counts_per_second, seconds, 4), Some(error));
    };
    refused(2, ratio(most, 1));
    refused(2, ratio(most / 2 + 1, 1));
    refused(u32::MAX, ratio(most, 1));
    refused(3, ratio(most / 2, LIMIT / 4 - 3));
    refused(1_000_000, ratio(most - 1, LIMIT));
    for (counts_per_second, seconds) in [
        (1, ratio(most, 1)),
        (2, ratio(most / 2, 1)),
        (1, ratio(most - 1, LIMIT)),
        (1 << 31, ratio(most, 1 << 31)),
        (u32::MAX, ratio(1, LIMIT)),
        (1_000_000, dec!(0.000_000_000_000_000_01)),
    ] {
        assert_eq!(refusal(counts_per_second, seconds, 4), None, "{seconds} s");
    }
}

// The largest unit there is, through both paths: 2^64 - 1 is 4 steps of 2^62 less one count.
#[test]
fn the_last_that_is_accepted_still_counts() {
    let mut clock = Accumulator::new(1, ratio(LIMIT as i64, 1), 9).unwrap();
    let all_but_one = ratio(LIMIT as i64 - 1, LIMIT);
    assert_eq!(clock.advance(LIMIT - 1).steps, 0);
    assert_eq!(clock.fraction(), all_but_one);
    assert_eq!((clock.advance(1).steps, clock.fraction()), (1, Ratio::ZERO));
    assert_eq!(clock.advance(u64::MAX).steps, 3);
    assert_eq!(clock.fraction(), all_but_one);
    assert_eq!(clock.advance(u64::MAX).steps, 4);
    assert_eq!(clock.fraction(), ratio(LIMIT as i64 - 2, LIMIT));
}

// A count is 2^62 / (2^32 - 1) steps, 2^30 and a quarter; 2^34 of them would pass 64 bits.
#[test]
fn the_shortest_step_that_is_accepted_still_counts() {
    let mut clock = Accumulator::new(u32::MAX, ratio(1, LIMIT), 1).unwrap();
    let mut exact = Exact::new(u32::MAX, ratio(1, LIMIT));
    let mut due = 0;
    for counts in [1, 3, u64::from(u32::MAX), 1 << 33, (1 << 33) - 1] {
        exact.elapsed += u128::from(counts);
        due += total(clock.advance(counts));
        assert_eq!(due, exact.steps());
        assert!(exact.has_fraction(clock.fraction()));
    }
}
