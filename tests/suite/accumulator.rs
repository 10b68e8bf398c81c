//! Frames of any length against exact rationals: the steps of a clock are `floor(elapsed / h)`,
//! after every frame and for ever.
//!
//! ```text
//! elapsed / h = counts den / (counts_per_second num)        h = num / den seconds
//! ```
//!
//! The reference keeps the sum of all counts in 128 bits and reduces nothing.

#[path = "accumulator/long.rs"]
mod long;
use crate::support;

use fixstep::{Accumulator, Due, Ratio, dec};
use support::Random;

/// Microseconds, a watch crystal, the processor of a Game Boy Advance, one of 133 MHz, and a
/// millisecond tick.
const CLOCKS: [u32; 5] = [1_000_000, 32_768, 16_777_216, 133_000_000, 1_000];

fn ratio(num: i64, den: u64) -> Ratio {
    Ratio::new(num, den).unwrap()
}

/// 60 Hz, one picture of a Game Boy Advance, and the dyadic step next to them.
fn lengths() -> [Ratio; 3] {
    [ratio(1, 60), ratio(4389, 1 << 18), ratio(1, 64)]
}

/// The sum of all counts, and what it comes to.
struct Exact {
    elapsed: u128,
    /// Steps per count, unreduced.
    num: u128,
    den: u128,
}

impl Exact {
    fn new(counts_per_second: u32, seconds: Ratio) -> Exact {
        Exact {
            elapsed: 0,
            num: seconds.den().into(),
            den: seconds.num() as u128 * u128::from(counts_per_second),
        }
    }

    fn steps(&self) -> u128 {
        self.elapsed * self.num / self.den
    }

    /// Whether `part` is what is left beside the whole steps, and less than one.
    fn has_fraction(&self, part: Ratio) -> bool {
        let (rest, den) = (self.elapsed * self.num % self.den, u128::from(part.den()));
        let num = u128::try_from(part.num()).unwrap();
        num < den && num * self.den == rest * den
    }
}

/// A frame: mostly between half and one and a half times 1/60 s; one in sixteen is up to eight
/// times as long, one in sixteen takes no time.
fn frame(random: &mut Random, counts_per_second: u32) -> u64 {
    let usual = u64::from(counts_per_second / 60);
    match random.next() % 16 {
        0 => random.next() % (8 * usual),
        1 => 0,
        _ => usual / 2 + random.next() % (usual + 1),
    }
}

fn total(due: Due) -> u128 {
    u128::from(due.steps) + u128::from(due.dropped)
}

/// Many frames; each makes at most `most` steps.
fn count(counts_per_second: u32, seconds: Ratio, most: u32) {
    let what = format!("{counts_per_second} Hz, {seconds} s, at most {most}");
    let mut clock = Accumulator::new(counts_per_second, seconds, most).unwrap();
    let mut exact = Exact::new(counts_per_second, seconds);
    let mut random = Random(u64::from(counts_per_second));
    let (mut due, mut dropped, mut over) = (0, 0, 0);
    for tick in 0..support::long(1_000_000) {
        let counts = frame(&mut random, counts_per_second);
        let now = clock.advance(counts);
        exact.elapsed += u128::from(counts);
        due += total(now);
        dropped += now.dropped;
        over += u32::from(now.dropped > 0);
        assert_eq!(due, exact.steps(), "{what}, frame {tick}");
        assert!(now.steps <= most && (now.dropped == 0 || now.steps == most));
        if tick % 1000 == 0 {
            let part = clock.fraction();
            assert!(exact.has_fraction(part), "{what}, frame {tick}: {part}");
        }
    }
    println!("{what:<48} {due:>8} due, {dropped:>6} dropped in {over:>5} frames");
    assert_eq!(dropped == 0, most == u32::MAX, "{what}");
}

#[test]
fn frames_make_every_step_that_is_due() {
    for clock in CLOCKS {
        for seconds in lengths() {
            count(clock, seconds, u32::MAX);
        }
    }
}

#[test]
fn frames_with_a_limit_make_it_or_drop_it() {
    for clock in CLOCKS {
        for seconds in lengths() {
            count(clock, seconds, 4);
        }
    }
}

/// Half a step, an hour, and on as before: the hour costs `most` steps and names what it drops.
fn stall(counts_per_second: u32, seconds: Ratio) {
    let mut clock = Accumulator::new(counts_per_second, seconds, 4).unwrap();
    let mut exact = Exact::new(counts_per_second, seconds);
    let mut advance = |counts: u64| {
        let before = exact.steps();
        exact.elapsed += u128::from(counts);
        let due = clock.advance(counts);
        assert_eq!(total(due), exact.steps() - before);
        assert!(exact.has_fraction(clock.fraction()));
        (due.steps, due.dropped)
    };
    let second = u64::from(counts_per_second);
    assert_eq!(advance(second / 150), (0, 0));
    let (steps, dropped) = advance(3600 * second);
    // An hour is 3600 den / num steps; half a step more may make one of it.
    let hour = 3600 * seconds.den() / seconds.num() as u64;
    assert_eq!(steps, 4);
    assert!(dropped == hour - 4 || dropped == hour - 3, "{dropped}");
    for _ in 0..1000 {
        let (steps, dropped) = advance(second / 60);
        assert!(steps <= 2 && dropped == 0, "{steps}, {dropped}");
    }
}

#[test]
fn an_hour_is_dropped_and_reported() {
    for seconds in lengths() {
        stall(1_000_000, seconds);
        stall(133_000_000, seconds);
    }
}

/// Frames of 2 ms and 1.25 h for each step of the frame before: the most steps a frame makes in
/// `frames` of them, all steps made, all dropped, and the counts that passed.
fn spiral(most: u32, frames: u32) -> (u32, u128, u128, u128) {
    const STEP_COSTS: u64 = 20_833; // 1.25 / 60 s in microseconds
    let mut clock = Accumulator::new(1_000_000, ratio(1, 60), most).unwrap();
    let (mut last, mut worst, mut made, mut dropped, mut elapsed) = (1, 0, 0, 0, 0);
    for _ in 0..frames {
        let counts = 2_000 + STEP_COSTS * u64::from(last);
        let due = clock.advance(counts);
        (last, worst) = (due.steps, worst.max(due.steps));
        made += u128::from(due.steps);
        dropped += u128::from(due.dropped);
        elapsed += u128::from(counts);
    }
    (worst, made, dropped, elapsed)
}

// Without a limit each frame makes 1.25 times as many steps as the one before, of which whole ones
// are due: 1.25^60 is 650,000. With one, a frame lasts at most 2 ms + 5 h.
#[test]
fn a_limit_ends_the_spiral_of_steps_that_take_too_long() {
    let (worst, _, dropped, _) = spiral(u32::MAX, 60);
    assert!(worst > 100_000 && dropped == 0, "{worst}, {dropped}");
    let (worst, made, dropped, elapsed) = spiral(4, 100_000);
    println!("at most {worst} steps a frame, {made} made, {dropped} dropped");
    assert_eq!(worst, 4);
    assert_eq!(made + dropped, elapsed * 60 / 1_000_000);
    // Of 5 h and 2 ms, 4 h are made: in the long run 1.12 steps a frame are dropped.
    assert!((100_000..120_000).contains(&dropped), "{dropped}");
}

#[test]
fn a_reset_forgets_the_part_and_nothing_else() {
    let mut clock = Accumulator::new(1_000_000, ratio(1, 60), 4).unwrap();
    let new = clock;
    assert_eq!(clock.advance(16_000).steps, 0);
    assert_eq!(clock.fraction(), dec!(0.96));
    clock.reset();
    assert_eq!((clock, clock.fraction()), (new, Ratio::ZERO));
    assert_eq!(clock.advance(16_000).steps, 0);
    assert_eq!(clock.advance(1_000).steps, 1);
    assert_eq!(clock.fraction(), dec!(0.02));
}
