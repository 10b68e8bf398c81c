//! Sets of point masses against exact rationals: centre, velocity, momentum and total mass.
//!
//! ```text
//! r = sum(m r) / sum(m)        Eq. 7 to 10 of the article
//! ```
//!
//! The reference sums whole numbers in 128 bits: masses over one denominator, positions in one
//! fraction of a metre that every number type here has.

#[path = "mass/fall.rs"]
mod fall;
#[path = "mass/limits.rs"]
mod limits;
use crate::support;

use fixstep::fixed::types::{I8F24, I12F20, I16F16, I20F12};
use fixstep::{CentreOfMass, PointMass, Ratio, Scalar, Vec2, dec};
use support::*;

impl Random {
    fn ratio(&mut self, num: u64, den: u64) -> Ratio {
        Ratio::new((self.next() % num) as i64 + 1, den).unwrap()
    }
}

/// A number type with values all over its range, each a whole number of `2^-GRID`.
trait Anywhere: Format {
    const GRID: u32;
    fn anywhere(random: &mut Random) -> Self;

    /// Units at the `largest` coordinate by which the mean of `n` may be off.
    fn bound(n: usize, largest: f64) -> f64;
}

/// Each of n products is rounded to half a unit, each weight to 2^-31 of itself: all weights are 1
/// together, so that is 2^-31 of the largest coordinate, a unit at the end of the range. Totals and
/// weights have 45 bits or more: another 2^-40.
macro_rules! fixed_anywhere {
    ($($fixed:ident $grid:literal),*) => {$(
        impl Anywhere for $fixed {
            const GRID: u32 = $grid;
            fn anywhere(random: &mut Random) -> Self {
                Self::of_units(random.next() as i32)
            }
            fn bound(n: usize, largest: f64) -> f64 {
                let weights = 2.0_f64.powi(-31) + 2.0_f64.powi(-40);
                n as f64 / 2.0 + largest / Self::unit(0.0) * weights
            }
        }
    )*};
}

fixed_anywhere!(I16F16 16, I12F20 20, I8F24 24, I20F12 12);

/// Floats of 24 and 40 bits up to 1024: longer ones would leave the reference no room. Weight,
/// product and each of n - 1 sums round to half an epsilon, less than a unit of the largest.
macro_rules! float_anywhere {
    ($($float:ident $grid:literal),*) => {$(
        impl Anywhere for $float {
            const GRID: u32 = $grid;
            fn anywhere(random: &mut Random) -> Self {
                let magnitude = (random.next() >> (64 - 10 - $grid)) as $float;
                let sign = if random.next().is_multiple_of(2) { 1.0 } else { -1.0 };
                sign * magnitude / (1_u64 << $grid) as $float
            }
            fn bound(n: usize, _: f64) -> f64 {
                n as f64 + 1.0
            }
        }
    )*};
}

float_anywhere!(f32 14, f64 30);

/// Ways to write a mass, each with a denominator that all of its kind share: decimals, fractions
/// whose denominators divide 27720, and floats of up to eight bits before the point.
const KINDS: [(&str, i128); 3] = [
    ("decimals", 1_000_000),
    ("fractions", 27_720),
    ("floats", 1 << 62),
];

fn mass(kind: usize, random: &mut Random) -> Ratio {
    match kind {
        0 => {
            let digits = (random.next() % 7) as u32;
            random.ratio(1000 * 10_u64.pow(digits), 10_u64.pow(digits))
        }
        1 => {
            let dens = [2, 3, 7, 8, 9, 11, 12, 28, 45, 77, 27_720];
            let den = dens[random.next() as usize % dens.len()];
            random.ratio(50_000, den)
        }
        _ => {
            let value = (random.next() >> 11) as f64 / 2.0_f64.powi(45);
            Ratio::from_f64(value + 1.0 / 512.0).unwrap()
        }
    }
}

type Set<S> = Vec<PointMass<S>>;

fn set<S: Anywhere>(kind: usize, n: usize, random: &mut Random) -> Set<S> {
    let one = |_| PointMass {
        position: Vec2::new(S::anywhere(random), S::anywhere(random)),
        velocity: Vec2::new(S::anywhere(random), S::anywhere(random)),
        mass: mass(kind, random),
    };
    (0..n).map(one).collect()
}

/// Masses in whole numbers of `1 / den`.
fn whole(mass: Ratio, den: i128) -> i128 {
    let num = i128::from(mass.num()) * den;
    assert_eq!(num % i128::from(mass.den()), 0);
    num / i128::from(mass.den())
}

fn on_grid<S: Anywhere>(value: S) -> i128 {
    let scaled = value.to_f64() * (1_u64 << S::GRID) as f64;
    assert_eq!(scaled.fract(), 0.0);
    scaled as i128
}

/// `sum(m a)` and `sum(m)`, exactly, of a quantity `a` of each point.
fn sums<S: Anywhere>(set: &Set<S>, den: i128, a: impl Fn(&PointMass<S>) -> S) -> (i128, i128) {
    let masses = set.iter().map(|point| whole(point.mass, den));
    let moments = masses.clone().zip(set).map(|(m, p)| m * on_grid(a(p)));
    (moments.sum(), masses.sum())
}

/// `value - sum / mass` in units at magnitude `at`. Whole parts cancel before a float is made.
fn off<S: Anywhere>(value: S, (sum, mass): (i128, i128), at: f64) -> f64 {
    let scale = (1_u64 << S::GRID) as f64;
    let (quotient, rest) = (sum.div_euclid(mass), sum.rem_euclid(mass));
    let off = value.to_f64() * scale - quotient as f64 - rest as f64 / mass as f64;
    off.abs() / scale / S::unit(at)
}

/// The four quantities a set has a mean of.
const PARTS: [usize; 4] = [0, 1, 2, 3];

fn part<S: Scalar>(position: Vec2<S>, velocity: Vec2<S>, i: usize) -> S {
    [position.x, position.y, velocity.x, velocity.y][i]
}

/// Errors of `CentreOfMass` over 200 sets of each size, in units and as parts of the bound.
fn means_are_near<S: Anywhere>(kind: usize) {
    let (name, den) = KINDS[kind];
    let (mut units, mut ratios, mut random) = (vec![], vec![], Random(kind as u64));
    for n in (1..=16).flat_map(|n| [n; 200]) {
        let set = set::<S>(kind, n, &mut random);
        let all = CentreOfMass::new(&set).unwrap();
        for i in PARTS {
            let a = |p: &PointMass<S>| part(p.position, p.velocity, i);
            let largest = set.iter().map(|p| a(p).to_f64().abs()).fold(0.0, f64::max);
            let error = off(
                part(all.position, all.velocity, i),
                sums(&set, den, a),
                largest,
            );
            units.push(error);
            ratios.push(error / S::bound(n, largest));
            assert!(n > 1 || error == 0.0, "one point is its own centre");
        }
    }
    let what = format!("{} {name}, units", S::name());
    within(S::bound(16, S::MAX.to_f64()), &what, &units);
    within(1.0, "  of the bound for its size", &ratios);
}

#[test]
fn centre_and_velocity_are_the_weighted_means() {
    for kind in 0..KINDS.len() {
        means_are_near::<f32>(kind);
        means_are_near::<f64>(kind);
        means_are_near::<I16F16>(kind);
        means_are_near::<I12F20>(kind);
        means_are_near::<I8F24>(kind);
        means_are_near::<I20F12>(kind);
    }
}

// Eq. 8 is Eq. 10: M v with the centre's velocity is the sum of the points' momenta, to M times
// what that velocity is off by, and two roundings of `f64`.
fn momentum_is_the_sum<S: Anywhere>(kind: usize) {
    let (mut ratios, mut random) = (vec![], Random(77 + kind as u64));
    let den = KINDS[kind].1;
    for n in (1..=16).flat_map(|n| [n; 50]) {
        let set = set::<S>(kind, n, &mut random);
        let momentum = CentreOfMass::new(&set).unwrap().momentum().array();
        for i in [2, 3] {
            let a = |p: &PointMass<S>| part(p.position, p.velocity, i);
            let (sum, mass) = sums(&set, den, a);
            let exact = sum as f64 / den as f64 / (1_u64 << S::GRID) as f64;
            let largest = set.iter().map(|p| a(p).to_f64().abs()).fold(0.0, f64::max);
            let mass = mass as f64 / den as f64;
            let floats = 4.0 * f64::EPSILON * mass * largest;
            let allowed = mass * S::bound(n, largest) * S::unit(largest) + floats;
            ratios.push((momentum[i - 2] - exact).abs() / allowed);
        }
    }
    let what = format!("{} {}, of the bound", S::name(), KINDS[kind].0);
    within(1.0, &what, &ratios);
}

#[test]
fn the_momentum_of_the_whole_is_the_sum_of_momenta() {
    for kind in 0..KINDS.len() {
        momentum_is_the_sum::<f32>(kind);
        momentum_is_the_sum::<f64>(kind);
        momentum_is_the_sum::<I16F16>(kind);
        momentum_is_the_sum::<I12F20>(kind);
        momentum_is_the_sum::<I8F24>(kind);
        momentum_is_the_sum::<I20F12>(kind);
    }
}
