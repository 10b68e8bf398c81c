//! What serde hands over is checked as a snapshot is: no world, point or id is made of what none
//! could have been.

use fixstep::fixed::types::I16F16;
use fixstep::{BodyId, Point, Vec2, World};
use serde::de::DeserializeOwned;
use serde_json::{Value, from_value, json, to_value};

use super::bytes::Kept;
use super::samples::{Small, saved, world};

type Fixed = Small<I16F16>;
type Float = Small<f32>;

/// Ids 0, 2 and 3; the next is 4.
fn three() -> Value {
    to_value(world::<I16F16>(3)).unwrap()
}

#[track_caller]
fn refused<T: DeserializeOwned>(value: &Value, why: &str) {
    let text = value.to_string();
    let errors = [
        from_value::<T>(value.clone())
            .err()
            .map(|error| error.to_string()),
        serde_json::from_str::<T>(&text)
            .err()
            .map(|error| error.to_string()),
    ];
    for error in errors {
        let error = error.unwrap_or_else(|| panic!("accepted: {text}"));
        assert!(error.contains(why), "{error}");
    }
}

fn with(mut value: Value, pointer: &str, field: Value) -> Value {
    *value.pointer_mut(pointer).unwrap() = field;
    value
}

#[test]
fn what_was_written_is_read() {
    let again: Fixed = from_value(three()).unwrap();
    assert_eq!(saved(&again), saved(&world::<I16F16>(3)));
}

#[test]
fn more_bodies_than_there_is_room_for() {
    fn room<const N: usize>() -> Result<usize, serde_json::Error> {
        from_value::<World<Point<I16F16>, N>>(three()).map(|world| world.len())
    }
    for error in [room::<0>(), room::<2>()] {
        assert!(error.unwrap_err().to_string().contains("invalid length"));
    }
    assert_eq!(room::<3>().unwrap(), 3);
    assert_eq!(room::<9>().unwrap(), 3);
}

#[test]
fn ids_that_do_not_rise() {
    for ids in [
        [0, 0, 3],
        [0, 3, 3],
        [3, 2, 0],
        [2, 0, 3],
        [0, 2, 4],
        [0, 2, u32::MAX],
    ] {
        refused::<Fixed>(&with(three(), "/ids", json!(ids)), "ids do not rise");
    }
}

#[test]
fn a_next_id_that_a_body_has() {
    for next in [0, 1, 3] {
        refused::<Fixed>(&with(three(), "/next", json!(next)), "ids do not rise");
    }
    let mut last: Fixed = from_value(with(three(), "/next", Value::Null)).unwrap();
    let extra = last.bodies()[0];
    assert!(last.add(extra).is_err() && last.len() == 3);
}

#[test]
fn more_ids_than_bodies_or_fewer() {
    for ids in [json!([]), json!([0, 1]), json!([0, 1, 2, 3])] {
        refused::<Fixed>(&with(three(), "/ids", ids), "not one for each body");
    }
    refused::<Fixed>(
        &with(three(), "/bodies", json!([])),
        "not one for each body",
    );
}

#[test]
fn numbers_that_are_no_id_or_tick() {
    for wrong in [
        json!(-1),
        json!(1_u64 << 32),
        json!(0.5),
        json!("0"),
        Value::Null,
    ] {
        refused::<BodyId>(&wrong, "");
        refused::<Fixed>(&with(three(), "/ids/0", wrong.clone()), "");
    }
    for wrong in [json!(-1), json!(1.5), Value::Null] {
        refused::<Fixed>(&with(three(), "/tick", wrong), "");
    }
}

fn masses<S: Kept + DeserializeOwned + serde::Serialize>(wrong: &[u64]) {
    for &bits in wrong {
        let of_world = to_value(world::<S>(3)).unwrap();
        let point = with(of_world["bodies"][1].clone(), "/inv_mass", json!(bits));
        refused::<Point<S>>(&point, "inv_mass is not that of a point");
        let world = with(of_world, "/bodies/1", point);
        refused::<Small<S>>(&world, "inv_mass is not that of a point");
    }
}

// As in a snapshot: without the highest bit of the mantissa, negative, zero, infinite, NaN; and more
// bits than the number has.
#[test]
fn an_inverse_mass_that_is_none() {
    masses::<I16F16>(&[
        0,
        10,
        0x3FFF_FFFF,
        0x8000_0000,
        0xC000_000A,
        1 << 32 | 0x4000_000A,
    ]);
    masses::<f32>(&[
        0,
        0x8000_0000,
        0xBF80_0000,
        0x7F80_0000,
        0x7FC0_0000,
        1 << 32 | 0x3F80_0000,
    ]);
    masses::<f64>(&[0, 1 << 63, f64::NAN.to_bits(), f64::INFINITY.to_bits()]);
}

const OBJECTS: [(&str, &[&str]); 3] = [
    ("", &["tick", "next", "ids", "bodies"]),
    ("/bodies/1", &["position", "velocity", "inv_mass"]),
    ("/bodies/1/position", &["x", "y"]),
];

#[test]
fn missing_fields() {
    for (object, fields) in OBJECTS {
        for field in fields {
            let mut value = three();
            let fields = value.pointer_mut(object).unwrap().as_object_mut().unwrap();
            fields.remove(*field).unwrap();
            refused::<Fixed>(&value, &format!("missing field `{field}`"));
        }
    }
}

// A field that this version does not know may be state that it would lose.
#[test]
fn unknown_fields() {
    for (object, _) in OBJECTS {
        let mut value = three();
        let fields = value.pointer_mut(object).unwrap().as_object_mut().unwrap();
        fields.insert("angle".into(), json!(0));
        refused::<Fixed>(&value, "unknown field `angle`");
    }
}

// JSON has no NaN: it is written as null, which is no number.
#[test]
fn nan_in_json() {
    let vector = to_value(Vec2::new(f32::NAN, 1.0)).unwrap();
    assert_eq!(vector, json!({ "x": null, "y": 1.0 }));
    refused::<Vec2<f32>>(&vector, "null");
}

// The last field of the last body stands at the end, so no shorter input is whole.
#[test]
fn postcard_that_ends_too_early() {
    let mut bytes = [0; 1000];
    let bytes = postcard::to_slice(&world::<f32>(8), &mut bytes).unwrap();
    for end in 0..bytes.len() {
        assert!(
            postcard::from_bytes::<Float>(&bytes[..end]).is_err(),
            "{end}"
        );
    }
    assert!(postcard::from_bytes::<Float>(bytes).is_ok());
}
