//! Bodies that carry, through serde and back: every bit in postcard and in JSON, and nothing that no
//! body could have been.

use fixstep::fixed::types::{I8F24, I12F20, I16F16, I20F12};
use fixstep::{Body, Carried, Carry, Step, Verlet, World, dec, vec2};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Value, from_value, json, to_value};

use super::bytes::Kept;
use super::samples;

type Few<S> = World<Carried<S>, 4>;

/// Three bodies that have something left over of place and velocity.
fn world<S: Kept + Carry>() -> Few<S> {
    let mut world = Few::new();
    for &point in samples::world::<S>(3).bodies() {
        let mut body = Carried::from(point);
        body.push(vec2(dec!(0.37), dec!(-0.23)).unwrap());
        world.add(body).unwrap();
    }
    for _ in 0..7 {
        world.step(&mut Verlet, &mut (), &Step::hz(60).unwrap());
    }
    world
}

/// Every word of every body.
fn words<S: Kept + Carry>(world: &Few<S>) -> Vec<u8> {
    let mut bytes = vec![0; Few::<S>::SNAPSHOT];
    let length = world.save(&mut bytes).unwrap();
    bytes.truncate(length);
    bytes
}

fn through<S: Kept + Carry + Serialize + DeserializeOwned>() {
    let world = world::<S>();
    let mut bytes = [0; 1000];
    let bytes = postcard::to_slice(&world, &mut bytes).unwrap();
    let again: Few<S> = postcard::from_bytes(bytes).unwrap();
    assert_eq!(words(&again), words(&world), "{} in postcard", S::name());
    let text = serde_json::to_string(&world).unwrap();
    let again: Few<S> = serde_json::from_str(&text).unwrap();
    assert_eq!(again.bodies(), world.bodies(), "{} in JSON", S::name());
    for end in 0..bytes.len() {
        assert!(postcard::from_bytes::<Few<S>>(&bytes[..end]).is_err());
    }
}

#[test]
fn bodies_that_carry_come_back() {
    through::<f32>();
    through::<I16F16>();
    through::<I12F20>();
    through::<I8F24>();
    through::<I20F12>();
}

/// 1.5 and -2 in units of 2^-16, nothing left over.
fn one() -> Value {
    let velocity = vec2::<I16F16>(dec!(1.5), -2).unwrap();
    to_value(Carried::new(vec2(1, -1).unwrap(), velocity, 1).unwrap()).unwrap()
}

#[test]
fn json_shows_the_fields_by_name() {
    let expected = json!({
        "fine": [[0x0001_0000, 0], [0xFFFF_0000_u32, 0]],
        "velocity": { "x": { "bits": 0x0001_8000 }, "y": { "bits": -0x0002_0000 } },
        "inv_mass": 0x4000_000A,
        "remainder": [0, 0],
    });
    assert_eq!(one(), expected);
}

#[track_caller]
fn refused(pointer: &str, field: Value, why: &str) {
    let mut value = one();
    *value.pointer_mut(pointer).unwrap() = field;
    let error = from_value::<Carried<I16F16>>(value)
        .unwrap_err()
        .to_string();
    assert!(error.contains(why), "{error}");
}

#[test]
fn what_no_body_could_have_been_is_refused() {
    let why = "is not that of a body";
    for bits in [(1_u64 << 14) + 1, 0x8000, 0xBFFF, 1 << 16, 1 << 32] {
        refused("/remainder/0", json!(bits), why);
        refused("/remainder/1", json!(bits), why);
    }
    for bits in [1_u64 << 32, u64::MAX] {
        refused("/fine/0/0", json!(bits), why);
        refused("/fine/1/1", json!(bits), why);
    }
    for bits in [0, 10, 0x3FFF_FFFF, 0x8000_0000_u32] {
        refused("/inv_mass", json!(bits), why);
    }
    refused("/fine/1", json!([1]), "invalid length");
    refused("/remainder", json!([0]), "invalid length");
}

#[test]
fn fields_are_neither_missing_nor_unknown() {
    for field in ["fine", "velocity", "inv_mass", "remainder"] {
        let mut value = one();
        value.as_object_mut().unwrap().remove(field).unwrap();
        let error = from_value::<Carried<I16F16>>(value).unwrap_err();
        assert!(
            error
                .to_string()
                .contains(&format!("missing field `{field}`"))
        );
    }
    let mut value = one();
    value["angle"] = json!(0);
    let error = from_value::<Carried<I16F16>>(value).unwrap_err();
    assert!(error.to_string().contains("unknown field `angle`"));
}
