//! One body, a brake or a spring on it, and the fractions by which their zones are told exactly.

use fixstep::{
    Anchor, Body, BodyId, Force, LinearDrag, Point, Ratio, SemiImplicitEuler, Step, Vec2, World,
};

use crate::support::*;

/// A coefficient in tenths, a mass, and a rate: `m / (2 k h)` is never whole, and further from a whole
/// number than coefficients are off.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    pub tenths: i64,
    pub mass: i32,
    pub rate: i32,
}

impl Case {
    pub fn k(&self) -> Ratio {
        Ratio::new(self.tenths, 10).unwrap()
    }

    /// `m / (2 k h)`, rounded down.
    pub fn edge(&self) -> i32 {
        self.mass * self.rate * 5 / self.tenths as i32
    }

    /// Steps by which a velocity of three edges has lost, with remainders, all but half a unit: at n
    /// units a step takes `n / (2 edges)`, so one unit takes `2 edges / n`, which sums to a logarithm.
    pub fn long(&self) -> u32 {
        let zone = f64::from(self.edge() + 1);
        (2.0 * zone * ((3.0 * zone).ln() + 2.0)) as u32
    }
}

/// Primes that divide no rate and no mass.
pub fn cases() -> impl Iterator<Item = Case> {
    const PRIMES: [i64; 16] = [
        7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 67, 71,
    ];
    let case = |(i, tenths)| Case {
        tenths,
        mass: [1, 2, 3, 5][i % 4],
        rate: [50, 60, 90, 120][i / 4],
    };
    PRIMES.into_iter().enumerate().map(case)
}

/// So many units along x and as many against y.
pub fn both<S: Grid>(units: i32) -> Vec2<S> {
    Vec2::new(S::of_units(units), S::of_units(-units))
}

pub type Scene<B> = World<B, 1>;

pub fn scene<B>(position: i32, velocity: i32, mass: i32) -> (Scene<B>, BodyId)
where
    B: Body<S: Grid> + From<Point<B::S>> + std::fmt::Debug,
{
    let point = Point::new(both(position), both(velocity), mass).unwrap();
    let world = world([B::from(point)]);
    let id = world.ids()[0];
    (world, id)
}

pub fn run<B: Body>(world: &mut Scene<B>, forces: &mut impl Force<B>, rate: i32, steps: u32) {
    let step = Step::hz(rate).unwrap();
    for _ in 0..steps {
        world.step(&mut SemiImplicitEuler, forces, &step);
    }
}

pub fn velocity<B: Body>(world: &Scene<B>) -> Vec2<B::S> {
    world.bodies()[0].velocity()
}

pub fn position<B: Body>(world: &Scene<B>) -> Vec2<B::S> {
    world.bodies()[0].position()
}

pub fn drag<S: Grid>(case: &Case, _: BodyId) -> LinearDrag<S> {
    LinearDrag::new(case.k()).unwrap()
}

pub fn damper<S: Grid>(case: &Case, id: BodyId) -> Anchor<S> {
    Anchor::new(id, Vec2::ZERO, 0, case.k()).unwrap()
}

pub fn spring<S: Grid>(case: &Case, id: BodyId) -> Anchor<S> {
    Anchor::new(id, Vec2::ZERO, case.k(), 0).unwrap()
}

pub fn rates() -> impl Iterator<Item = i32> {
    (0..16).map(|i| 30 + 7 * i)
}
