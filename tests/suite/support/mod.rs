//! What the acceptance tests share: number types that know their unit, every method under one
//! type, start values, and a report that NaN cannot pass.
#![allow(dead_code)]

pub mod pages;

use fixstep::fixed::types::extra::{LeEqU32, LeEqU64};
use fixstep::fixed::{FixedI32, FixedI64};
use fixstep::{
    Anchor, Between, Body, BodyId, ConstantAcceleration, Euler, Force, Method, Pefrl, Point, Ratio,
    Rk4, Scalar, SemiImplicitEuler, TimeStep, Vec2, Verlet, World,
};

/// Whether this is the lab, which has the time for long runs.
pub const LAB: bool = matches!(env!("CARGO_PKG_NAME").as_bytes(), b"fixstep-lab");

/// Steps of a long run: all of them in the lab, a fiftieth in the quick suite.
pub const fn long(steps: u64) -> u64 {
    if LAB { steps } else { steps / 50 }
}

/// A scalar that knows its name and the distance to its next value.
pub trait Format: Scalar {
    /// Its name in a report.
    fn name() -> String;

    /// Distance to the next value at magnitude `at`; the same everywhere in fixed point.
    fn unit(at: f64) -> f64;

    /// The largest relative error of a coefficient that is the product of two rounded ones.
    const COEFFICIENT: f64;
}

// A mantissa of 31 bits rounds by 2^-31; three roundings, or one odd span of 2^-30 and one.
impl<F: LeEqU32> Format for FixedI32<F> {
    fn name() -> String {
        format!("I{}F{}", 32 - F::U32, F::U32)
    }

    fn unit(_: f64) -> f64 {
        Self::DELTA.to_num()
    }

    const COEFFICIENT: f64 = 3.0 / (1_u64 << 31) as f64;
}

impl<F: LeEqU64> Format for FixedI64<F> {
    fn name() -> String {
        format!("I{}F{}", 64 - F::U32, F::U32)
    }

    fn unit(_: f64) -> f64 {
        Self::DELTA.to_num()
    }

    const COEFFICIENT: f64 = 3.0 / (1_u64 << 63) as f64;
}

macro_rules! float_format {
    ($float:ident) => {
        impl Format for $float {
            fn name() -> String {
                stringify!($float).into()
            }

            fn unit(at: f64) -> f64 {
                let at = at.abs() as $float;
                (at.next_up() - at) as f64
            }

            const COEFFICIENT: f64 = 1.5 * $float::EPSILON as f64;
        }
    };
}

float_format!(f32);
float_format!(f64);

/// Fixed point of 32 bits by its whole number of units.
pub trait Grid: Format {
    fn units(self) -> i32;
    fn of_units(units: i32) -> Self;
}

impl<F: LeEqU32> Grid for FixedI32<F> {
    fn units(self) -> i32 {
        self.to_bits()
    }

    fn of_units(units: i32) -> Self {
        Self::from_bits(units)
    }
}

/// The method of a run, chosen at run time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Scheme {
    Euler,
    ConstantAcceleration,
    SemiImplicitEuler,
    Verlet,
    Rk4,
    Pefrl,
}

/// The methods of the article and their kin: one force call a step, order 2 at most.
pub const SCHEMES: [Scheme; 4] = [
    Scheme::Euler,
    Scheme::ConstantAcceleration,
    Scheme::SemiImplicitEuler,
    Scheme::Verlet,
];

pub const ALL_SCHEMES: [Scheme; 6] = [
    Scheme::Euler,
    Scheme::ConstantAcceleration,
    Scheme::SemiImplicitEuler,
    Scheme::Verlet,
    Scheme::Rk4,
    Scheme::Pefrl,
];

impl Scheme {
    pub fn method<B: Body, const N: usize>(self) -> Chosen<B, N> {
        match self {
            Scheme::Euler => Chosen::Euler(Euler::new()),
            Scheme::ConstantAcceleration => Chosen::Constant(ConstantAcceleration::new()),
            Scheme::SemiImplicitEuler => Chosen::Semi(SemiImplicitEuler),
            Scheme::Verlet => Chosen::Verlet(Verlet),
            Scheme::Rk4 => Chosen::Rk4(Rk4::new()),
            Scheme::Pefrl => Chosen::Pefrl(Pefrl::new()),
        }
    }

    /// Drifts in a step: each rounds a position once.
    pub fn drifts(self) -> f64 {
        match self {
            Scheme::Euler | Scheme::SemiImplicitEuler => 1.0,
            Scheme::ConstantAcceleration | Scheme::Verlet | Scheme::Rk4 => 2.0,
            Scheme::Pefrl => 5.0,
        }
    }
}

/// Any of the methods.
pub enum Chosen<B: Body, const N: usize> {
    Euler(Euler<B, N>),
    Constant(ConstantAcceleration<B, N>),
    Semi(SemiImplicitEuler),
    Verlet(Verlet),
    Rk4(Rk4<B, N>),
    Pefrl(Pefrl<B::S>),
}

impl<B: Body, const N: usize> Method<B, N> for Chosen<B, N> {
    fn step<F: Force<B>, H: TimeStep<B::S>>(
        &mut self,
        ids: &[BodyId],
        bodies: &mut [B],
        forces: &mut F,
        step: &H,
        tick: u64,
    ) {
        match self {
            Chosen::Euler(method) => method.step(ids, bodies, forces, step, tick),
            Chosen::Constant(method) => method.step(ids, bodies, forces, step, tick),
            Chosen::Semi(method) => Method::<B, N>::step(method, ids, bodies, forces, step, tick),
            Chosen::Verlet(method) => Method::<B, N>::step(method, ids, bodies, forces, step, tick),
            Chosen::Rk4(method) => method.step(ids, bodies, forces, step, tick),
            Chosen::Pefrl(method) => Method::<B, N>::step(method, ids, bodies, forces, step, tick),
        }
    }

    fn between(&self, part: &Between<B::S>, before: &B, after: &B) -> Vec2<B::S> {
        match self {
            Chosen::Euler(method) => method.between(part, before, after),
            Chosen::Constant(method) => method.between(part, before, after),
            Chosen::Semi(method) => Method::<B, N>::between(method, part, before, after),
            Chosen::Verlet(method) => Method::<B, N>::between(method, part, before, after),
            Chosen::Rk4(method) => method.between(part, before, after),
            Chosen::Pefrl(method) => Method::<B, N>::between(method, part, before, after),
        }
    }
}

/// The exact ratio of a finite `f64`.
pub fn ratio(value: f64) -> Ratio {
    Ratio::from_f64(value).unwrap()
}

/// The scalar nearest to `value`.
pub fn scalar<S: Scalar>(value: f64) -> S {
    S::ratio(ratio(value)).unwrap()
}

pub fn vector<S: Scalar>(x: f64, y: f64) -> Vec2<S> {
    Vec2::new(scalar(x), scalar(y))
}

pub fn point<S: Scalar>(position: [f64; 2], velocity: [f64; 2], mass: f64) -> Point<S> {
    let [position, velocity] = [position, velocity].map(|[x, y]| vector(x, y));
    Point::new(position, velocity, ratio(mass)).unwrap()
}

/// A world of `bodies` in their order.
pub fn world<B: Body + std::fmt::Debug, const N: usize>(bodies: [B; N]) -> World<B, N> {
    let mut world = World::new();
    for body in bodies {
        world.add(body).unwrap();
    }
    world
}

/// An undamped anchor at the origin for every body of `world`.
pub fn anchors<B: Body, const N: usize>(
    world: &World<B, N>,
    stiffness: [f64; N],
) -> [Anchor<B::S>; N] {
    let anchor = |i: usize| Anchor::new(world.ids()[i], Vec2::ZERO, ratio(stiffness[i]), 0);
    std::array::from_fn(|i| anchor(i).unwrap())
}

/// The smallest softening that `Pull` takes with this constant, with room for its rounding: 32-bit
/// coefficients hold `constant / ε³` up to 2^30.
pub fn least_softening<S: Format>(constant: f64) -> f64 {
    let least = (constant / 2.0_f64.powi(30)).cbrt();
    (1.01 * least + S::unit(least)).max(S::unit(0.0))
}

/// Place `i` of a sequence that fills `0..1` evenly: multiples of the golden ratio.
pub fn spread(i: usize) -> f64 {
    (0.5 + i as f64 * 0.618_033_988_749_894_9).fract()
}

/// Angle `i` of a sequence that fills the circle evenly.
pub fn angle(i: usize) -> f64 {
    std::f64::consts::TAU * spread(i)
}

pub fn median(errors: &[f64]) -> f64 {
    let mut sorted = errors.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted[sorted.len() / 2]
}

/// The largest error; NaN if one of them is NaN.
pub fn maximum(errors: &[f64]) -> f64 {
    errors
        .iter()
        .copied()
        .fold(0.0, |a, b| if a >= b || a.is_nan() { a } else { b })
}

/// Prints median and maximum, and fails unless every error is within `bound`.
pub fn within(bound: f64, what: &str, errors: &[f64]) {
    let (median, max) = (median(errors), maximum(errors));
    println!("{what:<56} median {median:8.2e}  max {max:8.2e}  bound {bound:8.2e}");
    assert!(
        errors.len() >= 16,
        "{what}: only {} start values",
        errors.len()
    );
    assert!(
        errors.iter().all(|&error| error <= bound),
        "{what}: {max:e} > {bound:e}"
    );
}

/// Numbers that look random: a counter through a mixing function (splitmix64).
pub struct Random(pub u64);

impl Random {
    #[allow(clippy::should_implement_trait, reason = "it has no end")]
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }
}
