//! A number type from outside the crate keeps the number law and steps a world.
//!
//! Q16.16 in an `i32`, with factors of 40 fractional bits in an `i64`; plain code, not fast.

use crate::laws::integer::{Integer, Integers};
use crate::laws::{integer, judge, verbs};
use fixstep::scalar::Factor;
use fixstep::{
    Anchor, DyadicStep, Gravity, Point, Ratio, Scalar, SemiImplicitEuler, Step, TimeStep, Verlet,
    World, dec, vec2,
};

#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
struct Own(i32);

#[derive(Clone, Copy, Debug, PartialEq)]
struct Times(i64);

const FRACTION: u32 = 16;
const FACTOR: u32 = 40;

/// `num / den`, nearest, ties away from zero.
fn divided(num: i128, den: i128) -> i128 {
    let magnitude = (2 * num.abs() + den) / (2 * den);
    magnitude * num.signum()
}

/// As a value that can be negated.
fn own(raw: i128) -> Own {
    Own(raw.clamp(-i32::MAX as i128, i32::MAX as i128) as i32)
}

/// `ratio * 2^fraction`, rounded.
fn scaled(ratio: Ratio, fraction: u32) -> i128 {
    divided(i128::from(ratio.num()) << fraction, ratio.den().into())
}

impl Factor<Own> for Times {
    fn new(ratio: Ratio) -> Option<Times> {
        let raw = i64::try_from(scaled(ratio, FACTOR)).ok()?;
        (raw != 0 || ratio.num() == 0).then_some(Times(raw))
    }

    fn scale(self, value: Own) -> Own {
        own(divided(
            i128::from(self.0) * i128::from(value.0),
            1 << FACTOR,
        ))
    }

    fn to_f64(self) -> f64 {
        self.0 as f64 / (1_u64 << FACTOR) as f64
    }
}

impl Scalar for Own {
    type Coef = Times;
    type Span = Times;
    type InvMass = Times;
    type Sum = i128;
    type Gain = i128;

    const ZERO: Own = Own(0);
    const MAX: Own = Own(i32::MAX);
    const COEF_BITS: u32 = 63 - FACTOR;

    fn ratio(ratio: Ratio) -> Option<Own> {
        let raw = i32::try_from(scaled(ratio, FRACTION)).ok()?;
        (raw != i32::MIN).then_some(Own(raw))
    }

    fn plus(self, other: Own) -> Own {
        Own(self.0.saturating_add(other.0))
    }

    fn minus(self, other: Own) -> Own {
        Own(self.0.saturating_sub(other.0))
    }

    fn negated(self) -> Own {
        Own(self.0.saturating_neg())
    }

    fn times(self, other: Own) -> Own {
        Own::narrow(i128::from(self.0) * i128::from(other.0))
    }

    fn dyadic(self, num: u32, shift: u32) -> Own {
        own(divided(i128::from(self.0) * i128::from(num), 1 << shift))
    }

    fn gain(self, h: Times) -> i128 {
        i128::from(self.0) * i128::from(h.0)
    }

    // What the rounded sum grows by in this tick.
    fn gained(gain: i128, tick: u64) -> Own {
        let whole = i128::from(tick as u32);
        own(divided(gain * (whole + 1), 1 << FACTOR) - divided(gain * whole, 1 << FACTOR))
    }

    fn dot(a: [Own; 2], b: [Own; 2]) -> i128 {
        i128::from(a[0].0) * i128::from(b[0].0) + i128::from(a[1].0) * i128::from(b[1].0)
    }

    fn narrow(sum: i128) -> Own {
        own(divided(sum, 1 << FRACTION))
    }

    fn quotient(sum: i128, divisor: Self) -> Own {
        if divisor.0 > 0 {
            own(divided(sum, divisor.0.into()))
        } else {
            Own(0)
        }
    }

    fn length(v: [Own; 2]) -> Own {
        let fourfold = 4 * Own::dot(v, v) as u128;
        own(fourfold.isqrt().div_ceil(2) as i128)
    }

    fn inverse_length(v: [Own; 2], softening: Own) -> Times {
        let square = Own::dot(v, v) + i128::from(softening.0) * i128::from(softening.0);
        let inverse = (1_u128 << (2 * (FACTOR + FRACTION))).checked_div(square as u128);
        Times(inverse.map_or(0, u128::isqrt) as i64)
    }

    fn coef(self) -> Times {
        Times(i64::from(self.0) << (FACTOR - FRACTION))
    }

    fn mass(inverse: Times) -> Times {
        let mass = divided(1 << (2 * FACTOR), inverse.0.into());
        Times(mass.min(i64::MAX.into()) as i64)
    }

    fn product(a: Times, b: Times) -> Times {
        let raw = divided(i128::from(a.0) * i128::from(b.0), 1 << FACTOR);
        Times(raw.clamp(i64::MIN.into(), i64::MAX.into()) as i64)
    }

    fn is_inside(self) -> bool {
        self.0.unsigned_abs() < i32::MAX as u32
    }

    fn bits(self) -> u64 {
        self.0 as u64
    }

    fn to_f64(self) -> f64 {
        f64::from(self.0) / 65_536.0
    }
}

impl Integer for Own {
    const BITS: u32 = 32;
    const FRACTION: u32 = FRACTION;

    fn raw(self) -> i128 {
        self.0.into()
    }

    fn of_raw(raw: i128) -> Own {
        Own(raw.try_into().unwrap())
    }

    fn represented(factor: impl Factor<Own>) -> judge::Dyadic {
        integer::printed(factor)
    }
}

#[test]
fn keeps_the_law() {
    judge::corners::<Own, Integers>();
    judge::pairs::<Own, Integers>(1_000_000);
    judge::values::<Own, Integers>(20_000);
    judge::ratios::<Own, Integers>(20_000);
}

#[test]
fn keeps_the_law_of_gravitation() {
    verbs::inverse_lengths::<Own>(1, 100_000);
    verbs::masses::<Own, Integers>(1, 100_000);
    verbs::coefs::<Own, Integers>(100_000);
}

type Scene = (Gravity<Own>, Anchor<Own>);

fn scene() -> (World<Point<Own>, 4>, Scene) {
    let mut world = World::new();
    let ball = Point::new(vec2(1, 2).unwrap(), vec2(3, 0).unwrap(), 2).unwrap();
    let id = world.add(ball).unwrap();
    let gravity = Gravity::new(vec2(0, dec!(-9.81)).unwrap());
    let anchor = Anchor::new(id, vec2(0, 0).unwrap(), 8, 1).unwrap();
    (world, (gravity, anchor))
}

// m g = k y at rest: 2 kg * 9.81 m/s² / 8 N/m
#[test]
fn comes_to_rest_where_the_forces_cancel() {
    let (mut world, mut forces) = scene();
    let step = Step::<Own>::hz(60).unwrap();
    for _ in 0..6_000 {
        world.step(&mut SemiImplicitEuler, &mut forces, &step);
    }
    let at = world.bodies()[0].position().to_f64();
    assert!(at.x.abs() < 1e-3 && (at.y + 2.4525).abs() < 1e-3, "{at:?}");
}

// y = -g T²/2 after T = 2 s; every term is a multiple of the last place but g itself
#[test]
fn falls_as_far_as_it_should() {
    let mut world = World::<Point<Own>, 1>::new();
    world
        .add(Point::new(vec2(0, 0).unwrap(), vec2(0, 0).unwrap(), 1).unwrap())
        .unwrap();
    let mut gravity = Gravity::new(vec2::<Own>(0, -8).unwrap());
    let step = DyadicStep::<Own, 1, 6>::new().unwrap();
    for _ in 0..128 {
        world.step(&mut Verlet, &mut gravity, &step);
    }
    let body = world.bodies()[0];
    assert_eq!(body.velocity().y, Own(-16 << 16));
    assert_eq!(body.position().y, Own(-16 << 16));
    assert_eq!(TimeStep::times(&step, Own(64)), Own(1));
}
