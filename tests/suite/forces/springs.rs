//! `Anchor` and `Spring`: one step from rest, energies, and names that went stale.

use super::*;
use fixstep::{Anchor, BodyId, Pairs, Spring};

/// The velocities after one step of a sixteenth of a second that does not move positions first.
fn kicked<S: Scalar, const N: usize>(
    bodies: [Point<S>; N],
    force: impl Fn([BodyId; N]) -> Pairs<Spring<S>, [[BodyId; 2]; 1]>,
) -> Vec<[f64; 2]> {
    let mut world = World::<Point<S>, N>::new();
    let ids = bodies.map(|body| world.add(body).unwrap());
    world.step(
        &mut SemiImplicitEuler,
        &mut force(ids),
        &Sixteenth::new().unwrap(),
    );
    velocities(&world)
}

/// Of 5 m from the first to the second.
fn pair<S: Scalar>(velocity: [i32; 2]) -> [Point<S>; 2] {
    [point([1, 1], [0, 0], 1), point([4, 5], velocity, 2)]
}

#[track_caller]
fn near(got: &[[f64; 2]], expected: &[[f64; 2]], allowed: f64) {
    assert_eq!(got.len(), expected.len());
    for (got, expected) in got.iter().flatten().zip(expected.iter().flatten()) {
        assert!((got - expected).abs() <= allowed, "{got} is not {expected}");
    }
}

// (8 (1 - 3) - 2 * 5) / (16 * 4) along x, (8 (2 - 0) - 2 * -1) / (16 * 4) along y
fn anchored<S: Scalar>() {
    let mut world = World::<Point<S>, 1>::new();
    let id = world.add(point([3, 0], [5, -1], 4)).unwrap();
    let mut anchor = Anchor::new(id, vec2(1, 2).unwrap(), 8, 2).unwrap();
    assert_eq!(world.potential_energy(&anchor), 32.0); // 8 (4 + 4) / 2
    world.step(
        &mut SemiImplicitEuler,
        &mut anchor,
        &Sixteenth::new().unwrap(),
    );
    assert_eq!(velocities(&world), [[5.0 - 0.40625, -1.0 + 0.28125]]);
}

#[test]
fn an_anchor_pulls_and_brakes() {
    anchored::<f32>();
    anchored::<f64>();
    anchored::<I16F16>();
    anchored::<I20F12>();
    anchored::<I8F24>();
}

// 10 (5 - 2) / 16 along (3, 4) / 5 is (1.125, 1.5); 10 (5 - 7) / 16 is (-0.75, -1)
fn stretched_and_compressed<S: Scalar>() {
    let stretched = kicked(pair::<S>([0, 0]), |ids| {
        Pairs::new(Spring::new(2, 10, 0).unwrap(), [ids])
    });
    assert_eq!(stretched, [[1.125, 1.5], [-0.5625, -0.75]]);
    let compressed = kicked(pair::<S>([0, 0]), |ids| {
        Pairs::new(Spring::new(7, 10, 0).unwrap(), [ids])
    });
    assert_eq!(compressed, [[-0.75, -1.0], [0.375, 0.5]]);
    let relaxed = kicked(pair::<S>([0, 0]), |ids| {
        Pairs::new(Spring::new(5, 10, 3).unwrap(), [ids])
    });
    assert_eq!(relaxed, [[0.0, 0.0], [0.0, 0.0]]);
}

// Only the part along the line is braked: (0, 5) has 4 m/s of it, 2 * 4 / 16 = 1/2; (4, -3) none.
fn damped<S: Scalar>(unit: f64) {
    let apart = kicked(pair::<S>([0, 5]), |ids| {
        Pairs::new(Spring::new(5, 10, 2).unwrap(), [ids])
    });
    near(&apart, &[[0.3, 0.4], [-0.15, 4.8]], 2.0 * unit);
    let across = kicked(pair::<S>([4, -3]), |ids| {
        Pairs::new(Spring::new(5, 10, 2).unwrap(), [ids])
    });
    near(&across, &[[0.0, 0.0], [4.0, -3.0]], 0.0);
}

#[test]
fn a_spring_pulls_together_pushes_apart_and_brakes() {
    stretched_and_compressed::<f32>();
    stretched_and_compressed::<f64>();
    stretched_and_compressed::<I16F16>();
    stretched_and_compressed::<I8F24>();
    damped::<f32>(2.0_f64.powi(-23));
    damped::<I16F16>(2.0_f64.powi(-16));
    damped::<I8F24>(2.0_f64.powi(-24));
    damped::<I20F12>(2.0_f64.powi(-12));
}

#[test]
fn a_spring_takes_from_one_what_it_gives_to_the_other() {
    for x in 1..200 {
        let bodies = [point::<I16F16>([0, 0], [0, 0], 1), point([x, 7], [3, x], 1)];
        let v = kicked(bodies, |ids| {
            Pairs::new(Spring::new(dec!(1.3), dec!(7.7), dec!(0.9)).unwrap(), [ids])
        });
        assert_eq!(v[0], [3.0 - v[1][0], x as f64 - v[1][1]]);
    }
}

#[test]
fn a_spring_without_direction_waits() {
    let bodies = [point::<I16F16>([2, 2], [1, 0], 1), point([2, 2], [0, 1], 1)];
    assert_eq!(
        kicked(bodies, |ids| Pairs::new(
            Spring::new(3, 10, 1).unwrap(),
            [ids]
        )),
        [[1.0, 0.0], [0.0, 1.0]]
    );
    let itself = kicked([bodies[0]], |[id]| {
        Pairs::new(Spring::new(3, 10, 1).unwrap(), [[id, id]])
    });
    assert_eq!(itself, [[1.0, 0.0]]);
}

#[test]
fn energy_of_a_spring() {
    let mut world = World::<Point<I16F16>, 2>::new();
    let [a, b] = pair([0, 0]).map(|body| world.add(body).unwrap());
    let spring = |length| Pairs::new(Spring::<I16F16>::new(length, 10, 1).unwrap(), [[a, b]]);
    assert_eq!(world.potential_energy(&spring(2)), 45.0); // 10 * 3² / 2
    assert_eq!(world.potential_energy(&spring(7)), 20.0); // 10 * 2² / 2
    assert_eq!(world.potential_energy(&[spring(2), spring(7)]), 65.0);
}

// The anchor carries 5 kg: y = -5 * 8 / 80. The spring carries 3 kg: 1 + 3 * 8 / 32 long.
#[test]
fn bodies_hang_where_the_forces_cancel() {
    let mut world = World::<Point<I16F16>, 2>::new();
    let top = world.add(point([0, 0], [0, 0], 2)).unwrap();
    let low = world.add(point([0, -1], [0, 0], 3)).unwrap();
    let mut forces = (
        Gravity::new(vec2(0, -8).unwrap()),
        Anchor::new(top, vec2(0, 0).unwrap(), 80, 20).unwrap(),
        Pairs::new(Spring::new(1, 32, 10).unwrap(), [[top, low]]),
    );
    let step = DyadicStep::<I16F16, 1, 6>::new().unwrap();
    (0..4_000).for_each(|_| world.step(&mut Euler::<_, 2>::new(), &mut forces, &step));
    let y = [top, low].map(|id| world.get(id).unwrap().position().y.to_num::<f64>());
    assert!(
        (y[0] + 0.5).abs() < 1e-3 && (y[1] + 0.5 + 1.75).abs() < 1e-3,
        "{y:?}"
    );
}

#[test]
fn forces_on_bodies_that_are_gone_do_nothing() {
    let mut world = World::<Point<I16F16>, 3>::new();
    let [gone, stays] = pair([0, 0]).map(|body| world.add(body).unwrap());
    let mut forces = (
        Anchor::new(gone, vec2(9, 9).unwrap(), 8, 2).unwrap(),
        Pairs::new(Spring::new(2, 10, 1).unwrap(), [[gone, stays]]),
        Pairs::new(Spring::new(2, 10, 1).unwrap(), [[stays, gone]]),
    );
    world.remove(gone).unwrap();
    world.add(point([7, 7], [0, 0], 1)).unwrap();
    assert_eq!(world.potential_energy(&forces), 0.0);
    for _ in 0..3 {
        world.step(&mut Verlet, &mut forces, &Sixteenth::new().unwrap());
        world.step(
            &mut Euler::<_, 3>::new(),
            &mut forces,
            &Sixteenth::new().unwrap(),
        );
    }
    assert_eq!(velocities(&world), [[0.0, 0.0]; 2]);
}
