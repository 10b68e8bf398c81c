//! Negated velocities and the same ticks backwards lead back to the bit: PEFRL and Verlet are their own
//! mirror images, products are odd, and forces of position see the same positions again.

use fixstep::{
    AllPairs, Anchor, Body, BodyId, DyadicStep, Force, Gravity, Method, Pairs, PerBody, Point,
    Pull, Push, Scalar, Spring, Step, Time, TimeStep, Vec2, World, dec,
};

use super::support::*;
use super::{I8F24, I12F20, I16F16};

const N: usize = 4;
const TICKS: u64 = if LAB { 2000 } else { 200 };

fn scene<S: Format>(i: usize) -> World<Point<S>, N> {
    world(std::array::from_fn(|k| {
        let (sin, cos) = angle(i * N + k).sin_cos();
        let mass = 0.7 + spread(k + i);
        point([3.0 * cos, 2.0 * sin], [-sin, 0.8 * cos], mass)
    }))
}

/// Of position and time only; all that the crate has.
fn forces<S: Format>(ids: &[BodyId]) -> impl Force<Point<S>> + use<S> {
    let quarter: S = scalar(0.25);
    let pulse = move |time: Time, body: &Point<S>| match time.half_ticks() % 3 {
        0 => body.position().map(|x| x.times(quarter).negated()),
        _ => Vec2::ZERO,
    };
    (
        Gravity::new(vector(0.013, -0.0171)),
        AllPairs(Pull::new(dec!(0.8), dec!(0.7)).unwrap()),
        std::array::from_fn::<_, N, _>(|k| Anchor::new(ids[k], Vec2::ZERO, 2, 0).unwrap()),
        Pairs::new(
            Spring::new(dec!(1.2), 5, 0).unwrap(),
            [[ids[0], ids[1]], [ids[1], ids[3]]],
        ),
        Push::new(ids[2], vector(0.03, 0.07)),
        PerBody(pulse),
    )
}

/// Whether a scene comes back after `TICKS` steps forth and as many back.
fn comes_back<S: Grid>(scheme: Scheme, step: &impl TimeStep<S>, i: usize) -> bool {
    let world = scene::<S>(i);
    let ids = world.ids();
    let (mut forces, mut method) = (forces::<S>(ids), scheme.method::<Point<S>, N>());
    let mut bodies = world.bodies().to_vec();
    for tick in 0..TICKS {
        method.step(ids, &mut bodies, &mut forces, step, tick);
    }
    assert!(bodies != world.bodies(), "at rest");
    assert!(bodies.iter().all(Body::is_inside), "out of range");
    turn(&mut bodies);
    for tick in (0..TICKS).rev() {
        method.step(ids, &mut bodies, &mut forces, step, tick);
    }
    turn(&mut bodies);
    bodies == world.bodies()
}

/// `v = -v`
fn turn<S: Scalar>(bodies: &mut [Point<S>]) {
    for body in bodies {
        body.set_velocity(-body.velocity()).unwrap();
    }
}

fn check<S: Grid>() {
    for scheme in [Scheme::Pefrl, Scheme::Verlet] {
        for i in 0..8 {
            let step = Step::hz(60).unwrap();
            assert!(
                comes_back::<S>(scheme, &step, i),
                "{} {scheme:?}",
                S::name()
            );
            let step = DyadicStep::<S, 1, 6>::new().unwrap();
            assert!(
                comes_back::<S>(scheme, &step, i),
                "{} {scheme:?}",
                S::name()
            );
        }
    }
    for scheme in [Scheme::Rk4, Scheme::SemiImplicitEuler] {
        let step = Step::hz(60).unwrap();
        assert!(
            !comes_back::<S>(scheme, &step, 0),
            "{} {scheme:?}",
            S::name()
        );
    }
}

#[test]
fn symmetric_methods_come_back_to_the_bit() {
    check::<I16F16>();
    check::<I12F20>();
    check::<I8F24>();
}
