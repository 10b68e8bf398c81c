//! Springs solved exactly that are refused, and those that wait.

use fixstep::{DyadicStep, ExactPair, ExactSpring, Scalar};

use super::*;

/// What both springs say to a frequency and a damping ratio: the same.
fn springs<S: fixstep::Decay>(hertz: Ratio, damping_ratio: Ratio) -> Errors {
    let mut world = World::<Point<S>, 2>::new();
    let ids = [1, 2].map(|mass| world.add(point(mass).unwrap()).unwrap());
    vec![
        refused(ExactSpring::<S>::new(
            ids[0],
            Vec2::ZERO,
            hertz,
            damping_ratio,
        )),
        refused(ExactPair::<S>::new(ids, Vec2::ZERO, hertz, damping_ratio)),
    ]
}

fn each(pairs: &[(Ratio, Ratio)]) -> Errors {
    let both = |&(hertz, damping)| {
        [
            springs::<I16F16>(hertz, damping),
            springs::<f32>(hertz, damping),
        ]
        .concat()
    };
    pairs.iter().flat_map(both).collect()
}

pub fn frequencies_of_nothing() -> Errors {
    each(&[
        (dec!(0), dec!(0)),
        (dec!(-1), dec!(0.5)),
        (dec!(0), dec!(-1)),
    ])
}

pub fn damping_below_zero() -> Errors {
    each(&[(dec!(1), dec!(-0.001)), (dec!(1000000), dec!(-3000))])
}

pub fn beyond() -> Errors {
    // The last that are taken: a unit less.
    let slowest = Ratio::new(1, 1 << 20).unwrap();
    for (hertz, damping) in [
        (dec!(1048575), dec!(0)),
        (slowest, dec!(0)),
        (dec!(1), dec!(1023)),
    ] {
        for answer in each(&[(hertz, damping)]) {
            assert!(answer.starts_with("accepted"), "{hertz} Hz {damping}");
        }
    }
    each(&[
        (dec!(1048576), dec!(0)),
        (Ratio::new(1, (1 << 20) + 1).unwrap(), dec!(0)),
        (Ratio::new(1, 1 << 62).unwrap(), dec!(1)),
        (dec!(4000000000000), dec!(0.5)),
        (dec!(1), dec!(1024)),
        (dec!(1), dec!(4000000000000)),
    ])
}

/// What a spring at `x` says to gravity of `g`.
fn sag<S: Scalar>(x: i32, hertz: Ratio, g: i32) -> String {
    let mut world = World::<Point<S>, 1>::new();
    let id = world.add(point(1).unwrap()).unwrap();
    let spring = ExactSpring::<S>::new(id, vec2(x, 0).unwrap(), hertz, 0).unwrap();
    refused(spring.with_gravity(vec2(g, 0).unwrap()))
}

pub fn sags() -> Errors {
    // 10 m/s² over (2 π / 100)² is 2533 m.
    assert!(sag::<I16F16>(30_000, dec!(0.01), 10).starts_with("accepted"));
    vec![
        sag::<I16F16>(31_000, dec!(0.01), 10),
        sag::<I8F24>(0, dec!(0.01), 10),
        // Far beyond, where the sum with the point is inside again once the sag has saturated.
        sag::<I16F16>(-30_000, dec!(0.001), 10),
        // Beyond any coefficient: 1/ω² is 2^30.6.
        sag::<I16F16>(0, dec!(0.000004), 1),
    ]
}

/// Springs whose body is gone, and a pair that has lost one: the others drift.
pub fn waiting_springs() {
    let (mut world, gone) = with_a_gap();
    let id = world.ids()[0];
    let moving = vec2(3, 4).unwrap();
    world.get_mut(id).unwrap().set_velocity(moving).unwrap();
    let mut forces = (
        ExactSpring::new(gone, vec2(1, 1).unwrap(), 5, 0).unwrap(),
        ExactPair::new([gone, id], Vec2::ZERO, 5, 0).unwrap(),
        ExactPair::new([id, gone], Vec2::ZERO, 5, 0).unwrap(),
    );
    let step = DyadicStep::<I16F16, 1, 6>::new().unwrap();
    (0..64).for_each(|_| world.step(&mut SemiImplicitEuler, &mut forces, &step));
    let body = world.bodies()[0];
    assert_eq!((body.position(), body.velocity()), (moving, moving));
}
