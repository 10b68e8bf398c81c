//! A gram, a kilogram and a ton under forces in proportion move alike: `h / m` joins the coefficient
//! before the product, so neither end loses the unit or the range that an impulse would need.

use super::*;
use fixstep::{AllBodies, Anchor, PerBody, Time};

const MASSES: [(i64, u64); 3] = [(1, 1000), (1, 1), (1000, 1)];

fn masses() -> [Ratio; 3] {
    MASSES.map(|(num, den)| Ratio::new(num, den).unwrap())
}

/// The state of a body of `mass` after `steps` steps of 1/60 s from x = 10 m, v = 100 m/s.
fn moved<S: Scalar>(mass: Ratio, steps: u32, force: impl Force<Point<S>>) -> [f64; 2] {
    let mut world = World::<Point<S>, 1>::new();
    world.add(point([10, 0], [100, 0], mass)).unwrap();
    let (step, mut force) = (Step::hz(60).unwrap(), force);
    (0..steps).for_each(|_| world.step(&mut SemiImplicitEuler, &mut force, &step));
    let body = world.bodies()[0];
    [body.position().x.to_f64(), body.velocity().x.to_f64()]
}

// v (1 - 1/60)^n; each product rounded by half a unit, which drag of 1/60 a step adds up to 30.
// The mass is represented within 1.5e-8 and h within 1e-9, 3.5 s long: 5e-6 m/s of the first 100.
fn drag_slows_alike<S: Scalar>(unit: f64) {
    for mass in masses() {
        let [_, v] = moved::<S>(mass, 210, LinearDrag::new(mass).unwrap());
        let exact = 100.0 * (1.0 - 1.0 / 60.0_f64).powi(210);
        assert!(
            (v - exact).abs() <= 30.5 * unit + 5e-6,
            "{mass} kg: {v}, {exact}"
        );
    }
}

#[test]
fn drag_slows_light_and_heavy_alike() {
    drag_slows_alike::<f64>(0.0);
    drag_slows_alike::<I16F16>(2.0_f64.powi(-16));
    drag_slows_alike::<I8F24>(2.0_f64.powi(-24));
}

// One step: v + h (-10 * 10 - 2 * 100) = 100 - 5. Two products and a sum: a unit and a half; the
// mass 1.5e-8 of 5.
fn anchor_pulls_alike<S: Scalar>(unit: f64) {
    let mut world = World::<Point<S>, 1>::new();
    let id = world.add(point([0, 0], [0, 0], 1)).unwrap();
    for mass in masses() {
        let times = |k: i64| Ratio::new(k * mass.num(), mass.den()).unwrap();
        let [_, v] = moved::<S>(
            mass,
            1,
            Anchor::new(id, Vec2::ZERO, times(10), times(2)).unwrap(),
        );
        assert!((v - 95.0).abs() <= 1.5 * unit + 1e-7, "{mass} kg: {v}");
    }
}

#[test]
fn an_anchor_pulls_light_and_heavy_alike() {
    anchor_pulls_alike::<f64>(0.0);
    anchor_pulls_alike::<I16F16>(2.0_f64.powi(-16));
    anchor_pulls_alike::<I8F24>(2.0_f64.powi(-24));
}

// 0.5 mN on 1 g for 60 steps: 0.5 m/s. Half a unit a step; the force itself is off by half a unit of
// 2^-24, a part in 16777.
#[test]
fn a_function_moves_a_gram() {
    let force = I8F24::ratio(dec!(0.0005)).unwrap();
    let bound = 30.0 * 2.0_f64.powi(-24) + 0.5 / 16777.0;
    let mass = dec!(0.001);
    let [_, v] = moved(
        mass,
        60,
        PerBody(|_: Time, _: &Point<I8F24>| Vec2::new(force, I8F24::ZERO)),
    );
    assert!((v - 100.5).abs() <= bound, "{v}");
    let all = |_: Time, _: &[Point<I8F24>], _: usize| Vec2::new(force, I8F24::ZERO);
    let [_, v] = moved(mass, 60, AllBodies::<_, I8F24, 1>::new(all));
    assert!((v - 100.5).abs() <= bound, "{v}");
}

// Euler: the force is taken where the body was, x = 10, not where it has drifted to.
#[test]
fn euler_asks_at_the_old_place() {
    let mut world = World::<Point<f64>, 1>::new();
    world.add(point([10, 0], [100, 0], 1)).unwrap();
    let step = Sixteenth::new().unwrap();
    let mut force = PerBody(|_: Time, body: &Point<f64>| body.position());
    world.step(&mut Euler::new(), &mut force, &step);
    assert_eq!(velocities(&world), [[100.0 + 10.0 / 16.0, 0.0]]);
    world.step(&mut ConstantAcceleration::new(), &mut force, &step);
    assert_eq!(
        velocities(&world),
        [[100.625 + (10.0 + 100.0 / 16.0) / 16.0, 0.0]]
    );
}
