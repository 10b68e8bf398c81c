//! Counts beyond 64 bits of product, and both paths against each other.

use super::*;

/// Adds `counts` to both; the steps must agree.
fn advance(clock: &mut Accumulator, exact: &mut Exact, counts: u64) {
    let before = exact.steps();
    exact.elapsed += u128::from(counts);
    assert_eq!(total(clock.advance(counts)), exact.steps() - before);
    assert!(exact.has_fraction(clock.fraction()));
}

// 2^64 counts, a thousand times over: 2^74, times 2^18 well within the reference.
#[test]
fn the_largest_count_comes_out_exactly_again_and_again() {
    for counts_per_second in CLOCKS {
        for seconds in lengths() {
            let mut clock = Accumulator::new(counts_per_second, seconds, 7).unwrap();
            let mut exact = Exact::new(counts_per_second, seconds);
            for i in 0..1000 {
                advance(&mut clock, &mut exact, u64::MAX - i % 3);
                advance(&mut clock, &mut exact, i);
            }
        }
    }
}

// At 60 Hz and microseconds a count is 3/50,000 of a step, and 2^64 - 1 a multiple of three: with
// nothing left over that many thirds still fit 64 bits, with 1/50,000 of a step they do not.
#[test]
fn the_paths_meet_at_the_last_count_that_fits() {
    let last = [u64::MAX / 3, u64::from(u32::MAX) / 3]; // that a word of 64 and of 32 bits takes
    for (rest, last) in (0..3).flat_map(|rest| last.map(|last| (rest, last))) {
        for more in [last - 1, last, last + 1, last + 2] {
            let mut clock = Accumulator::new(1_000_000, ratio(1, 60), 4).unwrap();
            let mut exact = Exact::new(1_000_000, ratio(1, 60));
            advance(&mut clock, &mut exact, rest);
            advance(&mut clock, &mut exact, more);
            advance(&mut clock, &mut exact, 16_667);
        }
    }
}

/// What is due, and the clock after it, whatever the limit does to each part.
fn of_parts(mut clock: Accumulator, parts: &[u64]) -> (u128, Accumulator) {
    let due = parts.iter().map(|&counts| total(clock.advance(counts)));
    (due.sum(), clock)
}

#[test]
fn a_sum_of_counts_is_due_what_its_parts_are() {
    let mut random = Random(7);
    for seconds in lengths().into_iter().chain([dec!(0.016_666_666_666_7)]) {
        for counts_per_second in CLOCKS {
            let mut clock = Accumulator::new(counts_per_second, seconds, 3).unwrap();
            for i in 0..2000 {
                // From a few bits to all 64, so that either path meets either.
                let whole = random.next() >> (i % 60);
                let part = random.next() % whole.max(1);
                let at_once = of_parts(clock, &[whole]);
                assert_eq!(at_once, of_parts(clock, &[part, whole - part]));
                assert_eq!(at_once, of_parts(clock, &[0, whole - part, part, 0]));
                clock = at_once.1;
            }
        }
    }
}

// A count of a second is 60 steps: the largest makes 60 (2^64 - 1), more than 64 bits can say. The
// report ends there; it neither wraps nor panics, and the next frame is as any other.
#[test]
fn more_steps_than_64_bits_hold_are_reported_as_the_most_they_hold() {
    let mut clock = Accumulator::new(1, ratio(1, 60), 4).unwrap();
    let most = u64::MAX / 60;
    assert_eq!(total(clock.advance(most)), 60 * u128::from(most));
    assert_eq!(total(clock.advance(most + 1)), u128::from(u64::MAX));
    assert_eq!(total(clock.advance(u64::MAX)), u128::from(u64::MAX));
    assert_eq!((clock.advance(1).steps, clock.fraction()), (4, Ratio::ZERO));
}

const LIMIT: u64 = 1 << 62;

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
