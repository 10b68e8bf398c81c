//! Angles and bodies that turn, through serde and back: every bit in postcard and in JSON, and nothing
//! that no body could have been.

use fixstep::fixed::types::{I8F24, I16F16, I32F32};
use fixstep::rigid::{Centre, SavedRotor};
use fixstep::{
    Angle, Body, Carried, Point, RangeChecked, Rigid, Rotating, Saved, Step, Verlet, World, dec,
    vec2,
};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Value, from_value, json, to_value};

use super::bytes::Kept;
use super::samples::{self, saved};

/// A body that is pushed off its centre, a locked one, a kinematic one; seven steps on.
fn world<C>() -> World<Rigid<C>, 4>
where
    C: Centre<S: Kept, Rotor: SavedRotor> + Saved + From<Point<C::S>>,
{
    let points = samples::world::<C::S>(3);
    let [first, second, third] = [0, 1, 2].map(|i| points.bodies()[i]);
    let mut pushed = Rigid::new(C::from(first), dec!(0.7)).unwrap();
    let arm = vec2(dec!(0.41), dec!(0.13)).unwrap();
    pushed.push_off(arm, vec2(dec!(-0.37), dec!(1.23)).unwrap());
    let bodies = [
        pushed,
        Rigid::locked(C::from(second)).with_angle(Angle::turns(dec!(0.7))),
        Rigid::kinematic(third.position(), third.velocity()).unwrap(),
    ];
    let mut world = World::new();
    for body in bodies {
        world.add(body).ok().unwrap();
    }
    let (_, last) = world.iter_mut().last().unwrap();
    *last = last.with_spin(dec!(-0.3)).unwrap();
    for _ in 0..7 {
        world.step(&mut Verlet, &mut (), &Step::hz(60).unwrap());
    }
    world
}

fn through<C>()
where
    C: Centre<S: Kept, Rotor: SavedRotor> + Saved + From<Point<C::S>>,
    Rigid<C>: Serialize + DeserializeOwned,
{
    let world = world::<C>();
    let mut bytes = [0; 1000];
    let bytes = postcard::to_slice(&world, &mut bytes).unwrap();
    let again: World<Rigid<C>, 4> = postcard::from_bytes(bytes).unwrap();
    assert_eq!(saved(&again), saved(&world));
    let text = serde_json::to_string(&world).unwrap();
    let again: World<Rigid<C>, 4> = serde_json::from_str(&text).unwrap();
    assert_eq!(saved(&again), saved(&world));
    for end in 0..bytes.len() {
        assert!(postcard::from_bytes::<World<Rigid<C>, 4>>(&bytes[..end]).is_err());
    }
}

#[test]
fn bodies_that_turn_come_back() {
    through::<Point<f32>>();
    through::<Point<I16F16>>();
    through::<Carried<f32>>();
    through::<Carried<I8F24>>();
    let mut body = RangeChecked::new(world::<Point<I16F16>>().bodies()[0]);
    for outside in [false, true] {
        let again: RangeChecked<Rigid<Point<I16F16>>> =
            from_value(to_value(body).unwrap()).unwrap();
        assert_eq!((again, again.was_outside()), (body, outside));
        (0..2).for_each(|_| body.kick(vec2(30_000, 0).unwrap()));
    }
}

#[test]
fn an_angle_is_its_count() {
    let angle = Angle::<I16F16>::turns(dec!(-0.25));
    assert_eq!(to_value(angle).unwrap(), json!(0xC000_0000_u32));
    assert_eq!(
        from_value::<Angle<I16F16>>(json!(0xC000_0000_u32)).unwrap(),
        angle
    );
    let wide = Angle::<I32F32>::turns(dec!(-0.25));
    assert_eq!(to_value(wide).unwrap(), json!(0xC000_0000_0000_0000_u64));
    for wrong in [json!(1_u64 << 32), json!(-1), json!(0.5), Value::Null] {
        assert!(from_value::<Angle<f32>>(wrong).is_err());
    }
}

/// 1 kg of 1 kg m² in units of 2^-16, a quarter turn on, with half a turn a second.
fn one<C: Centre<S = I16F16> + From<Point<I16F16>>>() -> Rigid<C> {
    let velocity = vec2(dec!(1.5), -2).unwrap();
    let point = Point::new(vec2(1, -1).unwrap(), velocity, 1).unwrap();
    let body = Rigid::new(C::from(point), 1).unwrap();
    let body = body.with_angle(Angle::turns(dec!(0.25)));
    body.with_spin(dec!(0.5)).unwrap()
}

fn plain() -> Value {
    to_value(one::<Point<I16F16>>()).unwrap()
}

fn carried() -> Value {
    to_value(one::<Carried<I16F16>>()).unwrap()
}

/// `1 / 2π` is `517C C1B7` of hexadecimal digits over `2^33`.
const INVERSE: u64 = 33 << 32 | 0x517C_C1B7;
/// Zero, over the `2^16` of the scalar.
const NONE: u64 = 16 << 32;

#[test]
fn json_shows_the_fields_by_name() {
    let velocity = json!({ "x": { "bits": 0x0001_8000 }, "y": { "bits": -0x0002_0000 } });
    let expected = json!({
        "centre": {
            "position": { "x": { "bits": 0x0001_0000 }, "y": { "bits": -0x0001_0000 } },
            "velocity": velocity,
            "inv_mass": 0x4000_000A,
        },
        "driven": false,
        "angle": 0x4000_0000,
        "spin": { "bits": 0x8000 },
        "inv_inertia": INVERSE,
    });
    assert_eq!(plain(), expected);
    let expected = json!({
        "centre": {
            "fine": [[0x0001_0000, 0], [0xFFFF_0000_u32, 0]],
            "velocity": velocity,
            "inv_mass": 0x4000_000A,
            "remainder": [0, 0],
        },
        "driven": false,
        "angle": [0x4000_0000, 0],
        "spin": { "bits": 0x8000 },
        "inv_inertia": INVERSE,
        "remainder": 0,
    });
    assert_eq!(carried(), expected);
    let wall = Rigid::<Point<I16F16>>::static_at(vec2(1, 1).unwrap()).unwrap();
    let wall = to_value(wall).unwrap();
    assert_eq!(
        (&wall["driven"], &wall["inv_inertia"]),
        (&json!(true), &json!(NONE))
    );
    assert_eq!(wall["centre"]["inv_mass"], json!(0x4000_000A));
}

#[track_caller]
fn refused<C>(of: fn() -> Value, fields: &[(&str, Value)], why: &str)
where
    C: Centre,
    Rigid<C>: DeserializeOwned,
{
    let mut value = of();
    for (pointer, field) in fields {
        *value.pointer_mut(pointer).unwrap() = field.clone();
    }
    let error = from_value::<Rigid<C>>(value).err().unwrap().to_string();
    assert!(error.contains(why), "{error}");
}

#[test]
fn what_no_body_could_have_been_is_refused() {
    let why = "is not that of a body";
    let of = |mantissa: u64, shift: u64| json!(shift << 32 | mantissa);
    let wrong = [
        of(1, 33),
        of(0x3FFF_FFFF, 33),
        of(0xC000_0000, 62),
        of(0x8000_0000, 33),
        of(0x4000_0000, 0),
        of(0x4000_0000, 63),
        of(0x4000_0000, 256 + 33),
        of(0, 17),
    ];
    for inertia in wrong {
        let field = [("/inv_inertia", inertia)];
        refused::<Point<I16F16>>(plain, &field, why);
        refused::<Carried<I16F16>>(carried, &field, why);
    }
    for rest in [(1 << 14) + 1, 0x8000, 0xBFFF, 1 << 16] {
        refused::<Carried<I16F16>>(carried, &[("/remainder", json!(rest))], why);
    }
    refused::<Carried<I16F16>>(carried, &[("/angle/1", json!(1_u64 << 32))], why);
    refused::<Point<I16F16>>(plain, &[("/angle", json!(1_u64 << 32))], "angle");
    let no_mass = [("/centre/inv_mass", json!(0))];
    refused::<Point<I16F16>>(plain, &no_mass, "inv_mass is not that of a point");
    refused::<Carried<I16F16>>(carried, &no_mass, why);
}

// Driven: nothing turns it, and its centre is written with 1 kg.
#[test]
fn a_driven_body_has_neither_inertia_nor_another_mass() {
    let why = "is not that of a body";
    let driven = ("/driven", json!(true));
    let (heavy, none) = (json!(0x4000_000B), ("/inv_inertia", json!(NONE)));
    let mass = ("/centre/inv_mass", heavy);
    refused::<Point<I16F16>>(plain, std::slice::from_ref(&driven), why);
    refused::<Carried<I16F16>>(carried, std::slice::from_ref(&driven), why);
    refused::<Point<I16F16>>(plain, &[driven.clone(), none.clone(), mass.clone()], why);
    refused::<Carried<I16F16>>(carried, &[driven, none, mass], why);
    for number in [json!(1), json!("true"), Value::Null] {
        refused::<Point<I16F16>>(plain, &[("/driven", number)], "invalid type");
    }
    let mut value = plain();
    (value["driven"], value["inv_inertia"]) = (json!(true), json!(NONE));
    let body: Rigid<Point<I16F16>> = from_value(value).unwrap();
    assert!(body.has_infinite_mass());
}

fn fields<C>(of: fn() -> Value, fields: &[&str])
where
    C: Centre,
    Rigid<C>: DeserializeOwned,
{
    for field in fields {
        let mut value = of();
        value.as_object_mut().unwrap().remove(*field).unwrap();
        let error = from_value::<Rigid<C>>(value).err().unwrap().to_string();
        assert!(
            error.contains(&format!("missing field `{field}`")),
            "{error}"
        );
    }
    let mut value = of();
    value["torque"] = json!(0);
    let error = from_value::<Rigid<C>>(value).err().unwrap().to_string();
    assert!(error.contains("unknown field `torque`"), "{error}");
}

#[test]
fn fields_are_neither_missing_nor_unknown() {
    let names = [
        "centre",
        "driven",
        "angle",
        "spin",
        "inv_inertia",
        "remainder",
    ];
    fields::<Point<I16F16>>(plain, &names[..5]);
    fields::<Carried<I16F16>>(carried, &names);
}
