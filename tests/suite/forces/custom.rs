//! Forces of one's own, and forces in tuples, arrays, lists and behind references.

use super::*;
use fixstep::scalar::Factor;
use fixstep::{AllBodies, Anchor, BodyId, Pairs, PerBody, Spring, Time};

// 2 s after the start, at x = 3, m = 4: ((2 + 3) / 4, -v / 4) / 16
#[test]
fn a_function_sees_the_time_and_the_body() {
    let mut world = World::<Point<I16F16>, 1>::new();
    world.add(point([0, 0], [0, 0], 4)).unwrap();
    let step = Sixteenth::<I16F16>::new().unwrap();
    (0..32).for_each(|_| world.step(&mut Verlet, &mut (), &step));
    *world.iter_mut().next().unwrap().1 = point([3, 0], [0, 8], 4);
    let mut force = PerBody(|time: Time, body: &Point<I16F16>| {
        Vec2::new(
            time.seconds::<I16F16>().plus(body.position().x),
            -body.velocity().y,
        )
    });
    world.step(&mut SemiImplicitEuler, &mut force, &step);
    assert_eq!(velocities(&world), [[5.0 / 64.0, 8.0 - 8.0 / 64.0]]);
}

fn pulled_home<F: Force<Point<f64>>>(force: impl FnOnce(BodyId) -> F) -> u64 {
    let mut world = World::<Point<f64>, 1>::new();
    let id = world.add(point([3, -2], [1, 1], 2)).unwrap();
    let (mut force, step) = (force(id), Sixteenth::new().unwrap());
    (0..50).for_each(|_| world.step(&mut Euler::<_, 1>::new(), &mut force, &step));
    world.state_hash()
}

#[test]
fn a_function_of_the_body_does_what_an_anchor_does() {
    let own = |_: Time, body: &Point<f64>| body.position().map(|x| -8.0 * x);
    let anchor = |id| Anchor::new(id, Vec2::ZERO, 8, 0).unwrap();
    assert_eq!(pulled_home(|_| PerBody(own)), pulled_home(anchor));
}

/// Masses of 1, 2 and 3 kg, added in some order.
fn three(order: [usize; 3]) -> World<Point<I16F16>, 3> {
    let bodies = [
        point([1, 0], [0, 2], 1),
        point([-2, 3], [1, 0], 2),
        point([4, 4], [-1, 1], 3),
    ];
    let mut world = World::new();
    for place in order {
        world.add(bodies[place]).unwrap();
    }
    world
}

// Each is pushed by the velocity of the next: pushed one after the other, the last would see the
// first one moved.
#[test]
fn all_forces_are_known_before_the_first_acts() {
    let mut world = three([0, 1, 2]);
    let mut force = AllBodies::<_, I16F16, 3>::new(|_: Time, all: &[Point<I16F16>], i: usize| {
        assert_eq!(all.len(), 3);
        all[(i + 1) % 3].velocity()
    });
    world.step(
        &mut SemiImplicitEuler,
        &mut force,
        &Sixteenth::new().unwrap(),
    );
    let expected = [
        [1.0 / 16.0, 2.0],
        [1.0 - 1.0 / 32.0, 1.0 / 32.0],
        [-1.0, 1.0 + 2.0 / 48.0],
    ];
    for (got, expected) in velocities(&world)
        .iter()
        .flatten()
        .zip(expected.iter().flatten())
    {
        assert!(
            (got - expected).abs() <= 2.0_f64.powi(-17),
            "{got} is not {expected}"
        );
    }
}

/// Draws every body to every other in proportion to their distance; pushes later on.
fn attraction(time: Time, all: &[Point<I16F16>], i: usize) -> Vec2<I16F16> {
    let own = all[i].position();
    let pull = all
        .iter()
        .fold(Vec2::ZERO, |sum, other| sum + (other.position() - own));
    if time.half_ticks() < 60 { pull } else { -pull }
}

fn mass(body: &Point<I16F16>) -> f64 {
    1.0 / Factor::<I16F16>::to_f64(body.inv_mass())
}

/// The bodies after some steps, by mass.
fn after(mut method: impl Method<Point<I16F16>, 3>, order: [usize; 3]) -> Vec<Point<I16F16>> {
    let mut world = three(order);
    let mut force = AllBodies::<_, I16F16, 3>::new(attraction);
    let step = Step::hz(60).unwrap();
    (0..100).for_each(|_| world.step(&mut method, &mut force, &step));
    let mut bodies = world.bodies().to_vec();
    bodies.sort_by(|a, b| mass(a).total_cmp(&mass(b)));
    bodies
}

#[test]
fn the_order_of_bodies_does_not_matter() {
    for order in [[0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
        assert_eq!(after(Verlet, order), after(Verlet, [0, 1, 2]));
        assert_eq!(
            after(SemiImplicitEuler, order),
            after(SemiImplicitEuler, [0, 1, 2])
        );
        let euler = Euler::<_, 3>::new();
        assert_eq!(after(euler.clone(), order), after(euler, [0, 1, 2]));
    }
}

#[test]
fn bodies_beyond_the_room_of_a_force_feel_nothing() {
    let mut world = three([0, 1, 2]);
    let mut force = AllBodies::<_, I16F16, 1>::new(|_: Time, all: &[Point<I16F16>], _: usize| {
        assert_eq!(all.len(), 3);
        vec2(16, 16).unwrap()
    });
    world.step(&mut Verlet, &mut force, &Sixteenth::new().unwrap());
    assert_eq!(velocities(&world), [[1.0, 3.0], [1.0, 0.0], [-1.0, 1.0]]);
}

/// State and potential energy after some steps.
fn outcome<F: Force<Point<I16F16>>>(make: impl FnOnce([BodyId; 3]) -> F) -> (u64, f64) {
    let mut world = three([0, 1, 2]);
    let mut forces = make([0, 1, 2].map(|i| world.ids()[i]));
    let step = Step::hz(60).unwrap();
    (0..50).for_each(|_| world.step(&mut Verlet, &mut forces, &step));
    (world.state_hash(), world.potential_energy(&forces))
}

fn spring(bodies: [BodyId; 2]) -> Pairs<Spring<I16F16>, [[BodyId; 2]; 1]> {
    Pairs::new(Spring::new(dec!(1.5), 7, dec!(0.5)).unwrap(), [bodies])
}

#[test]
fn forces_act_alike_in_any_container() {
    let one_by_one = outcome(|[a, b, c]| (spring([a, b]), spring([b, c])));
    let list = |[a, b, c]: [BodyId; 3]| {
        heapless::Vec::<_, 4>::from_slice(&[spring([a, b]), spring([b, c])]).unwrap()
    };
    assert_eq!(outcome(list), one_by_one);
    assert_eq!(
        outcome(|[a, b, c]| [spring([a, b]), spring([b, c])]),
        one_by_one
    );
    assert_eq!(
        outcome(|[a, b, c]| ((), (spring([a, b]), ((spring([b, c]),),)))),
        one_by_one
    );
    assert_ne!(outcome(|[a, b, _]| [spring([a, b])]), one_by_one);
}

#[test]
fn no_forces_are_a_force() {
    let nothing = outcome(|_| ());
    assert_eq!(
        outcome(|_| heapless::Vec::<Pairs<Spring<I16F16>, [[BodyId; 2]; 1]>, 4>::new()),
        nothing
    );
    assert_eq!(outcome(|_| [(); 0]), nothing);
    assert_eq!(nothing.1, 0.0);
}

// Fields in a container: time and the body's own state reach each of them.
#[test]
fn fields_act_alike_in_any_container() {
    let gravity = Gravity::new(vec2(1, dec!(-9.81)).unwrap());
    let drag = LinearDrag::new(dec!(0.3)).unwrap();
    let pair = outcome(|_| (gravity, drag, drag));
    assert_eq!(outcome(|_| (gravity, [drag; 2])), pair);
    assert_eq!(
        outcome(|_| (
            gravity,
            heapless::Vec::<_, 2>::from_slice(&[drag; 2]).unwrap()
        )),
        pair
    );
    assert_ne!(outcome(|_| (gravity, [drag])), pair);
}

#[test]
fn a_borrowed_force_is_a_force() {
    let ids = three([0, 1, 2]).ids().to_vec();
    let (mut first, mut second) = (spring([ids[0], ids[1]]), [spring([ids[1], ids[2]])]);
    let expected = outcome(|_| (first, second));
    assert_eq!(outcome(|_| (&mut first, &mut second)), expected);
    let mut both = (first, second);
    assert_eq!(outcome(|_| &mut both), expected);
}
