//! Through serde and back: bit for bit in postcard, as readable fields in JSON. Two worlds are equal
//! when their snapshots are: those hold every bit, the tick and the next id.

use fixstep::fixed::types::{I8F24, I12F20, I16F16, I20F12, I32F32};
use fixstep::{Body, BodyId, GravityY, Point, RangeChecked, Step, Vec2, Verlet, World, dec, vec2};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::json;

use super::bytes::Kept;
use super::samples::{ROOM, Small, saved, world};

trait Written: Kept + Serialize + DeserializeOwned {}

impl<S: Kept + Serialize + DeserializeOwned> Written for S {}

fn through_postcard<T: Serialize + DeserializeOwned>(value: &T) -> T {
    let mut bytes = [0; 1000];
    let bytes = postcard::to_slice(value, &mut bytes).unwrap();
    postcard::from_bytes(bytes).unwrap()
}

fn through_json<T: Serialize + DeserializeOwned>(value: &T) -> T {
    serde_json::from_str(&serde_json::to_string(value).unwrap()).unwrap()
}

fn worlds<S: Written>(through: fn(&Small<S>) -> Small<S>) {
    for count in 0..=ROOM {
        let (mut world, name) = (world::<S>(count), S::name());
        let mut again = through(&world);
        assert_eq!(saved(&again), saved(&world), "{count} of {name}");
        for world in [&mut world, &mut again] {
            let mut gravity = GravityY::new(dec!(-0.7)).unwrap();
            for _ in 0..60 {
                world.step(&mut Verlet, &mut gravity, &Step::hz(60).unwrap());
            }
        }
        assert_eq!(again.state_hash(), world.state_hash(), "{count} of {name}");
        let extra = super::samples::world(1).bodies()[0];
        assert_eq!(again.add(extra), world.add(extra));
    }
}

#[test]
fn worlds_come_back_from_postcard() {
    worlds::<f32>(through_postcard);
    worlds::<f64>(through_postcard);
    worlds::<I16F16>(through_postcard);
    worlds::<I12F20>(through_postcard);
    worlds::<I8F24>(through_postcard);
    worlds::<I20F12>(through_postcard);
    worlds::<I32F32>(through_postcard);
}

// An `f32` is written with the digits that tell it from its neighbours. What a reader of JSON makes
// of an `f64` is its own affair.
#[test]
fn worlds_come_back_from_json() {
    worlds::<f32>(through_json);
    worlds::<I16F16>(through_json);
    worlds::<I12F20>(through_json);
    worlds::<I8F24>(through_json);
    worlds::<I20F12>(through_json);
    worlds::<I32F32>(through_json);
}

fn parts<S: Written>() {
    let world = world::<S>(3);
    for (id, body) in world.iter() {
        assert_eq!(through_postcard(&id), id);
        assert_eq!(through_json(&id), id);
        assert_eq!(through_postcard(body), *body);
        assert_eq!(through_json(body), *body);
        assert_eq!(through_postcard(&body.velocity()), body.velocity());
        assert_eq!(through_json(&body.velocity()), body.velocity());
    }
}

#[test]
fn ids_points_and_vectors_come_back() {
    parts::<f32>();
    parts::<I16F16>();
    parts::<I12F20>();
    parts::<I8F24>();
    parts::<I20F12>();
}

#[test]
fn nan_and_minus_zero_come_back_from_postcard() {
    for bits in [0x7FC1_2345, 0xFF80_0001, 0x7F80_0000, 0x8000_0000, 1] {
        let vector = Vec2::new(f32::from_bits(bits), 1.0);
        assert_eq!(through_postcard(&vector).x.to_bits(), bits);
    }
    let mut world = world::<f32>(2);
    let id = world.ids()[1];
    world
        .get_mut(id)
        .unwrap()
        .kick(Vec2::new(f32::NAN, f32::INFINITY));
    assert_eq!(saved(&through_postcard(&world)), saved(&world));
}

// 1.5, 2 and -1 as floats and in units of 2^-16; 1 kg as the bits of its inverse.
#[test]
fn json_shows_the_fields_by_name() {
    fn small<S: Kept>() -> World<Point<S>, 4> {
        let at = vec2(dec!(1.5), 2).unwrap();
        let body = Point::new(at, vec2(-1, 0).unwrap(), 1).unwrap();
        let mut world = World::new();
        let gone = world.add(body).unwrap();
        world.add(body).unwrap();
        world.remove(gone).unwrap();
        world.step(
            &mut Verlet,
            &mut (),
            &fixstep::DyadicStep::<S, 1, 1>::new().unwrap(),
        );
        world
    }
    let float = json!({ "tick": 1, "next": 2, "ids": [1], "bodies": [{
        "position": { "x": 1.0, "y": 2.0 },
        "velocity": { "x": -1.0, "y": 0.0 },
        "inv_mass": 0x3F80_0000,
    }] });
    assert_eq!(serde_json::to_value(small::<f32>()).unwrap(), float);
    let units = |x: i32, y: i32| json!({ "x": { "bits": x << 16 }, "y": { "bits": y << 16 } });
    let fixed = json!({ "tick": 1, "next": 2, "ids": [1], "bodies": [{
        "position": units(1, 2),
        "velocity": units(-1, 0),
        "inv_mass": 0x4000_000A,
    }] });
    assert_eq!(serde_json::to_value(small::<I16F16>()).unwrap(), fixed);
}

#[test]
fn an_id_is_its_number() {
    let id: BodyId = serde_json::from_str("4294967295").unwrap();
    assert_eq!(id.serial(), u32::MAX);
    assert_eq!(serde_json::to_string(&id).unwrap(), "4294967295");
}

#[test]
fn a_watched_body_keeps_its_mark() {
    let mut ball = RangeChecked::new(Point::<I16F16>::new(Vec2::ZERO, Vec2::ZERO, 1).unwrap());
    for kicks in [[0, 0], [30_000, -7]] {
        for x in kicks.into_iter().chain(kicks) {
            ball.kick(vec2(x, 0).unwrap());
        }
        ball.change(|point| point.set_velocity(Vec2::ZERO)).unwrap();
        assert_eq!(ball.was_outside(), kicks[0] != 0);
        assert_eq!(through_postcard(&ball), ball);
        assert_eq!(through_json(&ball), ball);
    }
    // The mark is not taken off a body that stands at the end.
    ball.change(|point| point.teleport(Vec2::new(I16F16::MAX, I16F16::ZERO)))
        .unwrap();
    let mut value = serde_json::to_value(ball).unwrap();
    value["was_outside"] = json!(false);
    let again: RangeChecked<Point<I16F16>> = serde_json::from_value(value.clone()).unwrap();
    assert!(again.was_outside());
    value
        .as_object_mut()
        .unwrap()
        .remove("was_outside")
        .unwrap();
    assert!(serde_json::from_value::<RangeChecked<Point<I16F16>>>(value).is_err());
}
