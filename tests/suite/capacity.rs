//! Room for `N` bodies, names that never mislead, and snapshots.

#[path = "capacity/hash.rs"]
mod hash;
#[path = "capacity/model.rs"]
mod model;

use std::sync::Mutex;

use fixstep::fixed::types::I16F16;
use fixstep::{
    Body, BodyId, DyadicStep, Gravity, Point, Spring, Stale, Step, Vec2, Verlet, World, dec, vec2,
};

type Ball = Point<I16F16>;

fn ball(x: i32) -> Ball {
    Point::new(vec2(x, 10).unwrap(), vec2(0, 0).unwrap(), 2).unwrap()
}

fn filled<const N: usize>() -> (World<Ball, N>, Vec<BodyId>) {
    let mut world = World::new();
    let ids = (0..N as i32).map(|x| world.add(ball(x)).unwrap()).collect();
    (world, ids)
}

fn xs<const N: usize>(world: &World<Ball, N>) -> Vec<i32> {
    world
        .iter()
        .map(|(_, body)| body.position().x.to_num())
        .collect()
}

#[test]
fn a_world_without_room_gives_the_body_back() {
    let mut none = World::<Ball, 0>::new();
    let refused = none.add(ball(7)).unwrap_err();
    assert_eq!((refused.body, refused.capacity), (ball(7), 0));
    assert!(none.is_empty() && none.iter().next().is_none());
}

#[test]
fn the_body_after_the_last_comes_back_and_the_rest_stay() {
    let (mut world, ids) = filled::<5>();
    let before = world.state_hash();
    let refused = world.add(ball(5)).unwrap_err();
    assert_eq!((refused.body, refused.capacity), (ball(5), 5));
    assert_eq!((world.len(), world.state_hash()), (5, before));
    assert_eq!(world.ids(), ids);
}

#[test]
fn room_that_was_given_up_is_used_again_under_another_name() {
    let (mut world, ids) = filled::<1>();
    assert_eq!(world.remove(ids[0]), Ok(ball(0)));
    let next = world.add(ball(1)).unwrap();
    assert_ne!(next, ids[0]);
    let stale = Stale(ids[0]);
    assert_eq!(world.get(ids[0]), Err(stale));
    assert_eq!(world.get_mut(ids[0]), Err(stale));
    assert_eq!(world.remove(ids[0]), Err(stale));
    assert_eq!(world.get(next), Ok(&ball(1)));
}

#[test]
fn a_refused_body_uses_up_no_name() {
    let (mut world, ids) = filled::<1>();
    let _ = world.add(ball(1));
    world.remove(ids[0]).unwrap();
    assert_eq!(world.add(ball(2)).unwrap().serial(), 1);
}

#[test]
fn bodies_stand_in_the_order_they_were_added() {
    let (mut world, ids) = filled::<6>();
    world.remove(ids[0]).unwrap();
    world.remove(ids[3]).unwrap();
    assert_eq!(xs(&world), [1, 2, 4, 5]);
    world.add(ball(9)).unwrap();
    assert_eq!(xs(&world), [1, 2, 4, 5, 9]);
    assert!(world.ids().windows(2).all(|pair| pair[0] < pair[1]));
}

#[test]
fn retain_asks_once_for_each_body_in_order() {
    let (mut world, ids) = filled::<6>();
    let mut asked = Vec::new();
    world.retain(|id, body| {
        asked.push(id);
        body.position().x != 2 && id != ids[5]
    });
    assert_eq!(asked, ids);
    assert_eq!(xs(&world), [0, 1, 3, 4]);
    assert_eq!(world.get(ids[4]), Ok(&ball(4)));
    assert_eq!(world.get(ids[2]), Err(Stale(ids[2])));
    assert_eq!(world.get(ids[5]), Err(Stale(ids[5])));
}

#[test]
fn clear_takes_all_bodies_but_gives_no_name_again() {
    let (mut world, ids) = filled::<3>();
    step(&mut world, 2);
    world.clear();
    assert!(world.is_empty() && world.ids().is_empty());
    assert_eq!(world.tick(), 2);
    let id = world.add(ball(0)).unwrap();
    assert!(ids.iter().all(|&old| old != id && world.get(old).is_err()));
}

#[test]
fn every_body_can_be_changed_between_steps() {
    let (mut world, ids) = filled::<3>();
    for (id, body) in world.iter_mut() {
        body.teleport(vec2(10 + id.serial() as i32, 0).unwrap())
            .unwrap();
    }
    assert_eq!(xs(&world), [10, 11, 12]);
    world.get_mut(ids[1]).unwrap().push(vec2(3, -1).unwrap());
    assert_eq!(
        world.get(ids[1]).unwrap().velocity(),
        vec2(dec!(1.5), dec!(-0.5)).unwrap()
    );
    assert_eq!(world.get(ids[0]).unwrap().velocity(), Vec2::ZERO);
    assert_eq!(world.iter().len(), 3);
    assert_eq!(world.iter_mut().len(), 3);
}

// The next step starts where the body was put: no method keeps an older state.
#[test]
fn a_teleported_body_goes_on_from_there() {
    let (mut world, ids) = filled::<1>();
    let mut forces = Gravity::new(vec2(0, -8).unwrap());
    let second = DyadicStep::<I16F16, 1, 1>::new().unwrap();
    world.step(&mut Verlet, &mut forces, &second);
    world
        .get_mut(ids[0])
        .unwrap()
        .teleport(vec2(100, 100).unwrap())
        .unwrap();
    world.step(&mut Verlet, &mut forces, &second);
    // 100 - v h - g h²/2 with v = 4, h = 1/2
    assert_eq!(
        world.get(ids[0]).unwrap().position(),
        vec2(100, 97).unwrap()
    );
}

fn step<const N: usize>(world: &mut World<Ball, N>, count: u32) {
    let mut forces = Gravity::new(vec2(dec!(0.3), dec!(-9.81)).unwrap());
    let step = Step::<I16F16>::hz(60).unwrap();
    (0..count).for_each(|_| world.step(&mut Verlet, &mut forces, &step));
}

#[test]
fn a_clone_is_a_snapshot() {
    let (mut world, ids) = filled::<4>();
    step(&mut world, 10);
    let mut snapshot = world.clone();
    world.remove(ids[1]).unwrap();
    step(&mut world, 50);
    assert_ne!(world.state_hash(), snapshot.state_hash());
    snapshot.remove(ids[1]).unwrap();
    step(&mut snapshot, 50);
    assert_eq!(world.state_hash(), snapshot.state_hash());
    assert_eq!(world.add(ball(8)), snapshot.add(ball(8)));
}

static WORLD: Mutex<World<Ball, 8>> = Mutex::new(World::new());

#[test]
fn a_world_lives_in_a_static() {
    let mut world = WORLD.lock().unwrap();
    let id = world.add(ball(3)).unwrap();
    step(&mut world, 1);
    assert_eq!((world.get(id).is_ok(), world.tick()), (true, 1));
}

#[test]
fn everything_may_cross_threads() {
    fn crosses<T: Send + Sync + 'static>() {}
    crosses::<World<Ball, 8>>();
    crosses::<BodyId>();
    crosses::<Step<I16F16>>();
    crosses::<DyadicStep<I16F16, 1, 6>>();
    crosses::<Spring<I16F16>>();
    crosses::<Gravity<f32>>();
    crosses::<fixstep::Euler<Ball, 8>>();
    crosses::<fixstep::Error>();
}
