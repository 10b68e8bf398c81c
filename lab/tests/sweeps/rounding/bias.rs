//! What roundings come to on the mean: nothing over all residues and in random order, but for ties of
//! a kick or a push, which all go one way.

use fixstep::fixed::types::{I8F24, I12F20, I16F16, I20F12};
use fixstep::scalar::Factor;
use fixstep::{Body, Point, Ratio, Scalar, Step, TimeStep, Vec2};

use crate::support::*;

/// How a product is added.
#[derive(Clone, Copy, Debug)]
enum Verb {
    Kick,
    Drift,
    Push,
}

const VERBS: [Verb; 3] = [Verb::Kick, Verb::Drift, Verb::Push];

/// Products of one verb with its factor, which for drifts takes turns.
struct Products<S: Scalar> {
    verb: Verb,
    coefficient: S::Coef,
    step: Step<S>,
    body: Point<S>,
    factors: [f64; 2],
}

impl<S: Grid> Products<S> {
    /// A kick by `factor`, a drift by a step of `factor`, or a push of a body of mass `1 / factor`.
    fn new(verb: Verb, factor: Ratio) -> Products<S> {
        let coefficient = S::Coef::new(factor).unwrap();
        let mass = Ratio::new(factor.den() as i64, factor.num() as u64).unwrap();
        let body = Point::new(Vec2::ZERO, Vec2::ZERO, mass).unwrap();
        let factors = match verb {
            Verb::Kick => [coefficient.to_f64(); 2],
            Verb::Drift => S::spans(factor).unwrap().map(Factor::to_f64),
            Verb::Push => [Factor::<S>::to_f64(body.inv_mass()); 2],
        };
        Products {
            verb,
            coefficient,
            step: Step::from_seconds(factor).unwrap(),
            body,
            factors,
        }
    }

    /// The product with so many units, in units.
    fn rounded(&self, tick: u64, units: i32) -> i32 {
        let mut body = self.body;
        let value = Vec2::new(S::of_units(units), S::ZERO);
        match self.verb {
            Verb::Kick => body.kick_by(value, self.coefficient),
            Verb::Push => body.push(value),
            Verb::Drift => {
                body.set_velocity(value).unwrap();
                body.drift(&self.step.at(tick));
                return body.position().x.units();
            }
        }
        body.velocity().x.units()
    }

    /// By how much it is rounded up, exactly: 31 bits by 21.
    fn error(&self, tick: u64, units: i32) -> f64 {
        let product = self.factors[(tick & 1) as usize] * f64::from(units);
        f64::from(self.rounded(tick, units)) - product
    }
}

/// Errors of `1 / r`, in r-ths of a unit, over all residues modulo r in two ticks. All but ties cancel:
/// r - j is rounded up where j is rounded down. The factor is off by less than a unit of r does.
fn over_residues<S: Grid>(verb: Verb, r: i32) -> i32 {
    let products = Products::<S>::new(verb, Ratio::new(1, r as u64).unwrap());
    let errors = |v: i32| (0..2).map(move |tick| (tick, v));
    let all = (10_000..10_000 + r).flat_map(errors);
    all.map(|(tick, v)| r * products.rounded(tick, v) - v).sum()
}

/// Where ties of `1 / r` go: where the factor is off, and outwards where it is not.
fn side<S: Grid>(verb: Verb, r: i32) -> i32 {
    let products = Products::<S>::new(verb, Ratio::new(1, r as u64).unwrap());
    if products.factors[0] * f64::from(r) < 1.0 {
        -1
    } else {
        1
    }
}

/// One in r is a tie for an even r. Drifts send it up in one tick and down in the other; kicks and
/// pushes send it one way, by half a unit: half a unit in r on the mean.
fn check_residues<S: Grid>() {
    for r in (30..46).chain([60, 64, 100, 120]) {
        let what = format!("{} by 1/{r}", S::name());
        assert_eq!(over_residues::<S>(Verb::Drift, r), 0, "{what}");
        for verb in [Verb::Kick, Verb::Push] {
            let ties = if r % 2 == 0 {
                side::<S>(verb, r) * r
            } else {
                0
            };
            assert_eq!(over_residues::<S>(verb, r), ties, "{what} {verb:?}");
        }
    }
}

#[test]
fn roundings_cancel_over_all_residues() {
    check_residues::<I20F12>();
    check_residues::<I16F16>();
    check_residues::<I12F20>();
    check_residues::<I8F24>();
}

/// At 60 Hz a velocity of 30 units modulo 60 is a tie in each tick: a point goes half a unit too far
/// in one and too short in the next.
fn check_turns<S: Grid>() {
    for i in 0..16 {
        let units = (30 + 60 * i * i) * if i % 2 == 0 { 1 } else { -1 };
        let velocity = Vec2::new(S::of_units(units), S::ZERO);
        let mut body = Point::<S>::new(Vec2::ZERO, velocity, 1).unwrap();
        let step = Step::<S>::hz(60).unwrap();
        for tick in 0..10_000 {
            body.drift(&step.at(tick));
            let twice = 2 * body.position().x.units() - (tick as i32 + 1) * (units / 30);
            let off = i32::from(tick % 2 == 0);
            assert_eq!(twice.abs(), off, "{} {units} tick {tick}", S::name());
        }
    }
}

#[test]
fn ties_at_60_hz_take_turns() {
    check_turns::<I20F12>();
    check_turns::<I16F16>();
    check_turns::<I12F20>();
    check_turns::<I8F24>();
}

const COUNTS: [u64; 5] = [1 << 8, 1 << 10, 1 << 12, 1 << 14, 1 << 16];

/// Sums of errors after each count, for values below 2^20 units: of both signs, or all greater than
/// zero.
fn sums<S: Grid>(products: &Products<S>, seed: u64, positive: bool) -> [f64; 5] {
    let (mut random, mut sum, mut tick) = (Random(seed), 0.0, 0);
    COUNTS.map(|count| {
        while tick < count {
            let bits = random.next();
            let units = (bits >> 44) as i32;
            let turned = !positive && bits & 1 == 1;
            sum += products.error(tick, if turned { -units } else { units });
            tick += 1;
        }
        sum
    })
}

/// N errors of variance 1/12 and mean zero: sums within five standard deviations each. Of 32 the root
/// mean square is off by `1/sqrt(64)` of itself, 0.054 decades, and a line through five counts, 0.6
/// decades apart, by five times `0.054 / sqrt(3.6)` in its power. `bias` is the mean of values above zero.
fn check_walks<S: Grid>(verb: Verb, factor: Ratio, bias: f64) {
    let products = Products::<S>::new(verb, factor);
    for positive in [false, true] {
        let mean = if positive { bias } else { 0.0 };
        let all: [[f64; 5]; 32] = std::array::from_fn(|i| sums(&products, i as u64, positive));
        let share = |sum: f64, n: f64| (sum - mean * n).abs() / (n / 12.0).sqrt();
        let (what, mut power) = (format!("{} {verb:?} mean {mean:.4}", S::name()), 0.0);
        for (k, count) in COUNTS.iter().enumerate() {
            let shares = all.map(|sums| share(sums[k], *count as f64));
            within(5.0, &format!("{what}, sum of {count}, deviations"), &shares);
            let square = shares.iter().map(|s| s * s).sum::<f64>() / 32.0;
            let log = (square * *count as f64).log10() / 2.0;
            power += (k as f64 - 2.0) * 4.0_f64.log10() * log / 3.6;
        }
        println!("{what}: power {power:.2}");
        assert!((power - 0.5).abs() <= 0.14, "{what}: {power}");
    }
}

/// By 10/291, which has no ties, and by 1/60, where those of kicks and pushes make 1/120 a product.
fn check_all_walks<S: Grid>() {
    for verb in VERBS {
        check_walks::<S>(verb, Ratio::new(10, 291).unwrap(), 0.0);
        let bias = match verb {
            Verb::Drift => 0.0,
            _ => f64::from(side::<S>(verb, 60)) / 120.0,
        };
        check_walks::<S>(verb, Ratio::new(1, 60).unwrap(), bias);
    }
}

#[test]
fn sums_of_roundings_walk_at_random() {
    check_all_walks::<I20F12>();
    check_all_walks::<I16F16>();
    check_all_walks::<I12F20>();
    check_all_walks::<I8F24>();
}
