//! `Push`, and `Window`, which bounds any force in time.

use super::*;
use fixstep::scalar::Factor;
use fixstep::{Anchor, BodyId, Push, Window};

/// The velocity after each of `count` steps from rest under `force`.
fn pushed<H: TimeStep<I16F16>>(
    mut method: impl Method<Point<I16F16>, 1>,
    force: Vec2<I16F16>,
    mass: Ratio,
    step: &H,
    count: usize,
) -> (Vec<Vec2<I16F16>>, f64) {
    let mut world = World::<Point<I16F16>, 1>::new();
    let id = world.add(point([0, 0], [0, 0], mass)).unwrap();
    let mut push = Push::new(id, force);
    let velocity = |_| {
        world.step(&mut method, &mut push, step);
        world.bodies()[0].velocity()
    };
    let velocities = (0..count).map(velocity).collect();
    let inverse = Factor::<I16F16>::to_f64(world.bodies()[0].inv_mass());
    (velocities, inverse)
}

// h = 4389/2^18 s and a mass of 2^k kg: h/m has 13 bits and F h/m at most 28 of fraction, all kept.
#[test]
fn a_push_gives_n_h_f_over_m_rounded_once() {
    let force = vec2::<I16F16>(dec!(0.31), dec!(-9.81)).unwrap();
    let step = DyadicStep::<I16F16, 4389, 18>::new().unwrap();
    for (mass, shift) in [
        (dec!(0.25), 16),
        (dec!(1), 18),
        (dec!(2), 19),
        (dec!(1024), 28),
    ] {
        let expected =
            |f: I16F16, n: usize| rounded(f.to_bits() as i128 * n as i128 * 4389, 1 << shift);
        let check = |(velocities, _): (Vec<Vec2<I16F16>>, f64)| {
            for (i, v) in velocities.into_iter().enumerate() {
                assert_eq!(v.x.to_bits() as i128, expected(force.x, i + 1), "{mass} kg");
                assert_eq!(v.y.to_bits() as i128, expected(force.y, i + 1), "{mass} kg");
            }
        };
        check(pushed(Verlet, force, mass, &step, 5_000));
        check(pushed(SemiImplicitEuler, force, mass, &step, 500));
        check(pushed(Euler::<_, 1>::new(), force, mass, &step, 500));
        check(pushed(
            ConstantAcceleration::<_, 1>::new(),
            force,
            mass,
            &step,
            500,
        ));
    }
}

// h and h/m are off by 2^-31 of themselves each, a gain by 2^-32 units: of at most 2^31 units of
// velocity after 10,000 ticks that is 1e-9 of the sum and 2e-6 units.
#[test]
fn a_push_on_any_mass_gives_n_h_f_over_m_rounded_once() {
    let (step, force) = (
        Step::<I16F16>::hz(60).unwrap(),
        vec2(dec!(-7.7), dec!(100)).unwrap(),
    );
    for mass in [dec!(0.3), dec!(3), dec!(70), dec!(1234567)] {
        let (velocities, inverse) = pushed(Verlet, force, mass, &step, 5_000);
        for (i, v) in velocities.into_iter().enumerate() {
            for (v, f) in v.array().into_iter().zip(force.array()) {
                let exact = f64::from(f.to_bits()) * inverse * (i + 1) as f64 / 60.0;
                let error = (f64::from(v.to_bits()) - exact).abs();
                assert!(
                    error <= 0.5 + 2e-6 + 1e-9 * exact.abs(),
                    "{mass} kg: {error} units"
                );
            }
        }
    }
}

fn push_by_hand<S: Scalar>() {
    let mut world = World::<Point<S>, 3>::new();
    let ids = [1, 2, 4].map(|mass| world.add(point([2, 3], [1, 0], mass)).unwrap());
    let mut push = Push::<S>::new(ids[1], vec2(8, -4).unwrap());
    world.step(&mut Verlet, &mut push, &Sixteenth::new().unwrap());
    // (8, -4) / 16 / 2
    assert_eq!(velocities(&world), [[1.0, 0.0], [1.25, -0.125], [1.0, 0.0]]);
    let at = world.bodies()[1].position().to_f64();
    assert_eq!(world.potential_energy(&push), -8.0 * at.x + 4.0 * at.y);
    world.remove(ids[1]).unwrap();
    world.step(&mut Verlet, &mut push, &Sixteenth::new().unwrap());
    assert_eq!(velocities(&world), [[1.0, 0.0]; 2]);
    assert_eq!(world.potential_energy(&push), 0.0);
}

#[test]
fn a_push_moves_one_body_and_nobody_once_it_is_gone() {
    push_by_hand::<f32>();
    push_by_hand::<f64>();
    push_by_hand::<I16F16>();
    push_by_hand::<I8F24>();
}

/// The steps, of `count`, in which the velocity of a body at rest changed under `force`.
fn acting<F: Force<Point<I16F16>>>(
    mut method: impl Method<Point<I16F16>, 1>,
    force: impl FnOnce(BodyId) -> F,
    count: u64,
) -> Vec<u64> {
    let mut world = World::<Point<I16F16>, 1>::new();
    let id = world.add(point([0, 0], [0, 0], 1)).unwrap();
    let mut force = force(id);
    let acts = |&tick: &u64| {
        let before = world.bodies()[0].velocity();
        assert_eq!(world.tick(), tick);
        world.step(&mut method, &mut force, &Sixteenth::new().unwrap());
        world.bodies()[0].velocity() != before
    };
    (0..count).filter(acts).collect()
}

fn gravity() -> GravityY<I16F16> {
    GravityY::new(-8).unwrap()
}

fn push(id: BodyId) -> Push<I16F16> {
    Push::new(id, vec2(3, 2).unwrap())
}

fn windows<M: Method<Point<I16F16>, 1>>(method: impl Fn() -> M) {
    let ticks: Vec<u64> = (5..9).collect();
    // A field, a couple, both in a tuple, a tuple of windows, a window in a window.
    assert_eq!(
        acting(method(), |_| Window::new(5..9, gravity()), 20),
        ticks
    );
    assert_eq!(
        acting(method(), |id| Window::new(5..9, push(id)), 20),
        ticks
    );
    let both = |id| ((), Window::new(5..9, (push(id), [gravity()])));
    assert_eq!(acting(method(), both, 20), ticks);
    let two = |id| (Window::new(5..7, push(id)), Window::new(7..9, gravity()));
    assert_eq!(acting(method(), two, 20), ticks);
    let nested = |id| Window::new(2..9, Window::new(5..30, (gravity(), push(id))));
    assert_eq!(acting(method(), nested, 20), ticks);
    assert_eq!(acting(method(), |_| Window::new(0..1, gravity()), 20), [0]);
    #[expect(clippy::reversed_empty_ranges)]
    for empty in [0..0, 7..7, 9..5] {
        let never = |id| Window::new(empty.clone(), (gravity(), push(id)));
        assert!(acting(method(), never, 20).is_empty(), "{empty:?}");
    }
}

#[test]
fn a_window_is_open_in_its_ticks_alone() {
    windows(|| Verlet);
    windows(|| SemiImplicitEuler);
    windows(Euler::<_, 1>::new);
    windows(ConstantAcceleration::<_, 1>::new);
}

// 4389/2^18 s: what falls due in a tick depends on its number alone, so two windows that meet give
// what none gives.
#[test]
fn windows_that_meet_are_no_windows() {
    let step = DyadicStep::<I16F16, 4389, 18>::new().unwrap();
    let g = || Gravity::new(vec2(dec!(0.3), dec!(-9.81)).unwrap());
    let whole = falling(Verlet, g(), &step, 300);
    let split = (Window::new(0..117, g()), Window::new(117..300, g()));
    assert_eq!(falling(Verlet, split, &step, 300), whole);
}

// k x² / 2 = 8 * 25 / 2, and F·x; after the last step in the window it is closed.
#[test]
fn a_closed_window_has_no_potential() {
    let mut world = World::<Point<I16F16>, 1>::new();
    let id = world.add(point([3, 4], [0, 0], 1024)).unwrap();
    let anchor = || Anchor::<I16F16>::new(id, Vec2::ZERO, 8, 0).unwrap();
    let mut forces = (Window::new(1..3, anchor()), Window::new(2..3, push(id)));
    assert_eq!(world.potential_energy(&forces), 0.0);
    let potential = [0, 1, 2, 3].map(|_| {
        world.step(
            &mut SemiImplicitEuler,
            &mut forces,
            &Sixteenth::new().unwrap(),
        );
        let energy = world.potential_energy(&forces);
        world
            .get_mut(id)
            .unwrap()
            .teleport(vec2(3, 4).unwrap())
            .unwrap();
        let there = world.potential_energy(&forces);
        assert!((energy - there).abs() < 0.1);
        there
    });
    assert_eq!(potential, [0.0, 100.0, 100.0 - 17.0, 0.0]);
}
