//! Each force against values worked out by hand.

#[path = "forces/air.rs"]
mod air;
#[path = "forces/custom.rs"]
mod custom;
#[path = "forces/masses.rs"]
mod masses;
#[path = "forces/pairs.rs"]
mod pairs;
#[path = "forces/pushes.rs"]
mod pushes;
#[path = "forces/springs.rs"]
mod springs;

use fixstep::fixed::types::{I8F24, I12F20, I16F16, I20F12};
use fixstep::{
    Body, ConstantAcceleration, DyadicStep, Euler, Force, Gravity, GravityY, LinearDrag, Method,
    Point, Ratio, Scalar, SemiImplicitEuler, Step, TimeStep, Vec2, Verlet, World, dec, vec2,
};

/// A quarter of a second, halved twice: exact in every scalar.
type Sixteenth<S> = DyadicStep<S, 1, 4>;

fn point<S: Scalar>(x: [i32; 2], v: [i32; 2], mass: impl Into<Ratio>) -> Point<S> {
    Point::new(vec2(x[0], x[1]).unwrap(), vec2(v[0], v[1]).unwrap(), mass).unwrap()
}

fn velocities<S: Scalar, const N: usize>(world: &World<Point<S>, N>) -> Vec<[f64; 2]> {
    world
        .bodies()
        .iter()
        .map(|body| body.velocity().to_f64().array())
        .collect()
}

/// `num / den`, nearest, ties away.
fn rounded(num: i128, den: i128) -> i128 {
    (2 * num.abs() + den) / (2 * den) * num.signum()
}

/// The velocity after each step from rest.
fn falling<H: TimeStep<I16F16>>(
    mut method: impl Method<Point<I16F16>, 1>,
    mut force: impl Force<Point<I16F16>>,
    step: &H,
    count: usize,
) -> Vec<Vec2<I16F16>> {
    let mut world = World::<Point<I16F16>, 1>::new();
    world.add(point([0, 0], [0, 0], 3)).unwrap();
    let velocity = |_| {
        world.step(&mut method, &mut force, step);
        world.bodies()[0].velocity()
    };
    (0..count).map(velocity).collect()
}

// 4389/2^18 s has 18 bits of fraction, so the sum is rounded from an exact value.
#[test]
fn gravity_gives_n_g_h_rounded_once() {
    let g = vec2::<I16F16>(dec!(0.3), dec!(-9.81)).unwrap();
    let step = DyadicStep::<I16F16, 4389, 18>::new().unwrap();
    let expected = |g: I16F16, n: usize| rounded(g.to_bits() as i128 * n as i128 * 4389, 1 << 18);
    let check = |velocities: Vec<Vec2<I16F16>>| {
        for (i, v) in velocities.into_iter().enumerate() {
            assert_eq!(v.x.to_bits() as i128, expected(g.x, i + 1));
            assert_eq!(v.y.to_bits() as i128, expected(g.y, i + 1));
        }
    };
    check(falling(Verlet, Gravity::new(g), &step, 5_000));
    check(falling(SemiImplicitEuler, Gravity::new(g), &step, 500));
    check(falling(Euler::<_, 1>::new(), Gravity::new(g), &step, 500));
    check(falling(
        ConstantAcceleration::<_, 1>::new(),
        Gravity::new(g),
        &step,
        500,
    ));
}

// h is off by 2^-31 of itself, which after 10,000 ticks is 0.05 units.
#[test]
fn gravity_at_60_hz_gives_n_g_h_rounded_once() {
    let step = Step::<I16F16>::hz(60).unwrap();
    let g = vec2::<I16F16>(0, dec!(-9.81)).unwrap();
    for (i, v) in falling(Verlet, Gravity::new(g), &step, 10_000)
        .into_iter()
        .enumerate()
    {
        let error = v.y.to_bits() as f64 - g.y.to_bits() as f64 * (i + 1) as f64 / 60.0;
        assert!(error.abs() <= 0.55, "{error} units after {} ticks", i + 1);
    }
}

#[test]
fn gravity_along_y_is_gravity_without_x() {
    let step = Step::<I16F16>::hz(60).unwrap();
    let both = Gravity::new(vec2(0, dec!(-9.81)).unwrap());
    let one = GravityY::new(dec!(-9.81)).unwrap();
    assert_eq!(
        falling(Verlet, both, &step, 1_000),
        falling(Verlet, one, &step, 1_000)
    );
    assert!(GravityY::<I16F16>::new(40_000).is_err());
}

#[test]
fn gravity_does_not_ask_for_the_mass() {
    let mut world = World::<Point<f64>, 3>::new();
    for mass in [dec!(0.001), dec!(1), dec!(1000)] {
        world.add(point([0, 0], [0, 0], mass)).unwrap();
    }
    let mut gravity = Gravity::new(vec2(dec!(0.5), -8).unwrap());
    world.step(&mut Verlet, &mut gravity, &Sixteenth::new().unwrap());
    assert_eq!(velocities(&world), [[0.03125, -0.5]; 3]);
}

/// One step of `v' = v (1 - k h / m)` for velocities of many sizes.
fn drag_is_the_articles<S: Scalar>(unit: f64) {
    let step = Step::<S>::hz(60).unwrap();
    for mass in [dec!(0.5), dec!(1), dec!(2), dec!(50)] {
        for v in [dec!(0.001), dec!(1), dec!(-3.7), dec!(100)] {
            let mut world = World::<Point<S>, 1>::new();
            let velocity = vec2(v, 1).unwrap();
            world
                .add(Point::new(Vec2::ZERO, velocity, mass).unwrap())
                .unwrap();
            world.step(&mut Verlet, &mut LinearDrag::new(dec!(0.4)).unwrap(), &step);
            let factor = 1.0 - 0.4 / 60.0 / mass.to_f64();
            // The impulse is rounded, divided by the mass, and rounded again; k h / m has 26 bits.
            let allowed = 0.5 * unit * (1.0 / mass.to_f64() + 1.0) + 2.0_f64.powi(-26);
            let got = velocities(&world)[0];
            let start = velocity.to_f64().array();
            for axis in 0..2 {
                assert!(
                    (got[axis] - start[axis] * factor).abs() <= allowed,
                    "{start:?} {got:?}"
                );
            }
        }
    }
}

#[test]
fn drag_is_v_less_k_h_over_m_of_v() {
    drag_is_the_articles::<f64>(0.0);
    drag_is_the_articles::<I16F16>(2.0_f64.powi(-16));
    drag_is_the_articles::<I8F24>(2.0_f64.powi(-24));
    drag_is_the_articles::<I20F12>(2.0_f64.powi(-12));
}

fn energies<S: Scalar>() {
    let mut world = World::<Point<S>, 2>::new();
    world.add(point([1, 3], [3, -4], 2)).unwrap();
    world.add(point([-2, 5], [0, 2], 4)).unwrap();
    assert_eq!(world.momentum().array(), [6.0, 0.0]); // 2 (3, -4) + 4 (0, 2)
    assert_eq!(world.kinetic_energy(), 33.0); // 2 * 25 / 2 + 4 * 4 / 2
    let gravity = Gravity::<S>::new(vec2(1, -8).unwrap());
    assert_eq!(
        world.potential_energy(&gravity),
        2.0 * (24.0 - 1.0) + 4.0 * (40.0 + 2.0)
    );
    let along_y = GravityY::<S>::new(-8).unwrap();
    assert_eq!(
        world.potential_energy(&(along_y, gravity)),
        2.0 * 47.0 + 4.0 * 82.0
    );
    assert_eq!(
        world.potential_energy(&LinearDrag::<S>::new(1).unwrap()),
        0.0
    );
}

#[test]
fn energies_and_momentum() {
    energies::<f32>();
    energies::<f64>();
    energies::<I16F16>();
    energies::<I8F24>();
    energies::<I12F20>();
}

#[test]
fn an_empty_world_has_none() {
    let world = World::<Point<f32>, 4>::new();
    assert_eq!(
        (world.kinetic_energy(), world.momentum()),
        (0.0, Vec2::ZERO)
    );
    assert_eq!(
        world.potential_energy(&Gravity::new(vec2::<f32>(0, -8).unwrap())),
        0.0
    );
}
