//! Equal masses, which get opposite changes, and a grain beside a planet.

use fixstep::fixed::types::{I8F24, I12F20, I16F16, I20F12};
use fixstep::{Vec2, World};

use crate::nbody::close::{pull, step};
use crate::nbody::scene::*;
use crate::support::*;

/// From one end of the range to the other: what one body gains, the other loses, to the bit.
fn check_opposite<S: Scale>() {
    let reach = if S::MAX.to_f64() < 1e30 {
        S::MAX.to_f64()
    } else {
        1e6
    };
    for i in 0..1000 {
        let size = reach * 2.0_f64.powi(-((i % 24) as i32));
        let [x, y, u, v] = [0, 1, 2, 3].map(|k| 1.99 * size * (spread(4 * i + k) - 0.5));
        let mass = 1000.0 * (1.37 + 0.9 * i as f64);
        let body = |x, y| point::<S>([x, y], [0.0; 2], mass);
        let mut world: World<_, 2> = world([body(x, y), body(u, v)]);
        let constant = size * size * size / mass;
        let constant = constant.clamp(1e-6, 5e8);
        let softening = (0.1 * size).max(S::unit(size));
        let mut pull = pull::<S>(constant, softening.max(least_softening::<S>(constant)));
        step(&mut world, Scheme::SemiImplicitEuler, &mut pull);
        let [a, b] = [0, 1].map(|k| world.bodies()[k].velocity());
        assert!(a == -b, "{} {i}: {a:?} {b:?}", S::name());
        assert!(a != Vec2::ZERO, "{} {i}", S::name());
    }
}

#[test]
fn equal_masses_get_opposite_changes() {
    check_opposite::<f32>();
    check_opposite::<f64>();
    check_opposite::<I16F16>();
    check_opposite::<I12F20>();
    check_opposite::<I8F24>();
    check_opposite::<I20F12>();
}

/// Two equal masses that mirror each other: so for ever. In fixed point, whose sums do not depend on
/// their order, with a third one between them.
fn check_mirror<S: Scale>(third: bool) {
    let (l, starts) = (S::LENGTH, (0..4).map(|i| angle(i).sin_cos()));
    for (scheme, (sin, cos)) in starts.flat_map(|start| SCHEMES.map(|s| (s, start))) {
        let body = |s: f64| {
            let velocity = [-0.3 * s * l, 0.1 * s * l];
            point::<S>([s * l * cos, s * l * sin], velocity, 1.37)
        };
        let mut world: World<_, 3> = World::new();
        let [a, b] = [1.0, -1.0].map(|s| world.add(body(s)).unwrap());
        let middle = third.then(|| world.add(body(0.0)).unwrap());
        let mut pull = pull::<S>(l * l * l / 8.0, 0.4 * l);
        for tick in 0..if LAB { 5000 } else { 500 } {
            step(&mut world, scheme, &mut pull);
            let state = |id| {
                world
                    .get(id)
                    .map(|body| [body.position(), body.velocity()])
                    .unwrap()
            };
            let same = state(a) == state(b).map(|v| -v);
            assert!(same, "{} {scheme:?} tick {tick}", S::name());
            middle
                .iter()
                .for_each(|&id| assert_eq!(state(id), [Vec2::ZERO; 2]));
        }
    }
}

#[test]
fn mirrored_equal_masses_stay_mirrored() {
    check_mirror::<f32>(false);
    check_mirror::<f64>(false);
    check_mirror::<I16F16>(true);
    check_mirror::<I12F20>(true);
    check_mirror::<I8F24>(true);
    check_mirror::<I20F12>(true);
}

/// One gram beside 1000 t, drawn at about `LENGTH` m/s²: one rounding to a unit of velocity, and the
/// coefficient. An impulse would be rounded to a unit itself, a thousand units of this velocity.
fn check_grain<S: Scale>() {
    let l = S::LENGTH;
    let law = Law {
        constant: f64::from((l.powi(3) / 1e6) as f32),
        softening: 0.125 * l,
    };
    let errors: [f64; 16] = std::array::from_fn(|i| {
        let ((sin, cos), r) = (angle(i).sin_cos(), l * (0.5 + spread(i + 30)));
        let grain = point::<S>([r * cos, r * sin], [0.0; 2], 1e-3);
        let planet = point::<S>([0.0; 2], [0.0; 2], 1e6);
        let mut world: World<_, 2> = world([grain, planet]);
        let before = stars(&world);
        step(&mut world, Scheme::SemiImplicitEuler, &mut law.pull());
        let (after, force) = (stars(&world), law.force(&before[0], &before[1]));
        let error = |axis: usize| {
            let exact = force[axis] / (60.0 * before[0].m);
            let allowed = 0.5 * S::unit(exact) + crate::nbody::pull_error::<S>() * exact.abs();
            (after[0].v[axis] - exact).abs() / allowed
        };
        maximum(&[error(0), error(1)])
    });
    within(
        1.0,
        &format!("{} grain, parts of its bound", S::name()),
        &errors,
    );
}

#[test]
fn a_grain_is_drawn_to_a_planet() {
    check_grain::<f32>();
    check_grain::<f64>();
    check_grain::<I16F16>();
    check_grain::<I12F20>();
    check_grain::<I8F24>();
    check_grain::<I20F12>();
}
