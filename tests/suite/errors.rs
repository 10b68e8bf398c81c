//! Every refusal: which call makes it, what it says, and that it changes nothing.

#[path = "errors/text.rs"]
mod text;

use fixstep::fixed::types::{I1F31, I8F24, I16F16};
use fixstep::{
    Anchor, BodyId, DyadicStep, Error, LinearDrag, Point, Ratio, Spring, Step, Vec2, World, dec,
    vec2,
};

fn ratio(num: i64, den: u64) -> Ratio {
    Ratio::new(num, den).unwrap()
}

fn mass(mass: Ratio) -> Result<Point<I16F16>, Error> {
    Point::new(Vec2::ZERO, Vec2::ZERO, mass)
}

fn some_id() -> BodyId {
    World::<Point<I16F16>, 1>::new()
        .add(mass(ratio(1, 1)).unwrap())
        .unwrap()
}

fn not_positive(field: &'static str, value: Ratio) -> Option<Error> {
    Some(Error::NotPositive { field, value })
}

fn negative(field: &'static str, value: Ratio) -> Option<Error> {
    Some(Error::Negative { field, value })
}

fn out_of_range(field: &'static str, value: Ratio) -> Option<Error> {
    Some(Error::OutOfRange { field, value })
}

fn rounds_to_zero(field: &'static str, value: Ratio) -> Option<Error> {
    Some(Error::RoundsToZero { field, value })
}

#[test]
fn masses() {
    for value in [ratio(0, 1), dec!(-1.5), ratio(-1, 1 << 62)] {
        assert_eq!(mass(value).err(), not_positive("mass", value));
        let float = Point::<f32>::new(Vec2::ZERO, Vec2::ZERO, value);
        assert_eq!(float.err(), not_positive("mass", value));
    }
    for value in [
        dec!(0.0004),
        ratio(1, 1 << 40),
        ratio(5_000_000, 1),
        ratio(1 << 62, 1),
    ] {
        assert_eq!(mass(value).err(), out_of_range("mass", value));
    }
    for value in [dec!(0.0005), ratio(2_000_000, 1), ratio(1, 3)] {
        assert_eq!(mass(value).err(), None);
    }
}

#[test]
fn states_that_are_not_finite() {
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for vector in [Vec2::new(bad, 0.0), Vec2::new(0.0, bad)] {
            let placed = Point::new(vector, Vec2::ZERO, 1);
            assert_eq!(placed, Err(Error::NotFinite { field: "position" }));
            let moving = Point::new(Vec2::ZERO, vector, 1);
            assert_eq!(moving, Err(Error::NotFinite { field: "velocity" }));
        }
    }
    for end in [f32::MAX, f32::MIN, f32::MIN_POSITIVE, -0.0] {
        assert!(Point::new(Vec2::new(end, end), Vec2::new(end, end), 1).is_ok());
    }
}

#[test]
fn a_refused_call_changes_nothing() {
    let (position, velocity) = (Vec2::new(1.0_f32, 2.0), Vec2::new(3.0, 4.0));
    let point = Point::new(position, velocity, 5).unwrap();
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for vector in [Vec2::new(bad, 9.0), Vec2::new(9.0, bad)] {
            let mut tried = point;
            assert_eq!(
                tried.teleport(vector),
                Err(Error::NotFinite { field: "position" })
            );
            assert_eq!(
                tried.set_velocity(vector),
                Err(Error::NotFinite { field: "velocity" })
            );
            assert_eq!(tried, point);
        }
    }
    let mut moved = point;
    moved.teleport(Vec2::new(7.0, 8.0)).unwrap();
    assert_eq!(
        (moved.position(), moved.velocity()),
        (Vec2::new(7.0, 8.0), velocity)
    );
}

#[test]
fn rates() {
    for value in [ratio(0, 1), ratio(-60, 1), dec!(-0.5)] {
        assert_eq!(Step::<I16F16>::hz(value).err(), not_positive("rate", value));
        assert_eq!(Step::<f32>::hz(value).err(), not_positive("rate", value));
    }
    for value in [ratio(4, 1), dec!(3.999), ratio(1, 1), ratio(1, 1 << 62)] {
        assert_eq!(Step::<I16F16>::hz(value).err(), out_of_range("rate", value));
        assert_eq!(Step::<I8F24>::hz(value).err(), out_of_range("rate", value));
        assert_eq!(
            Step::<f32>::hz(value).err(),
            out_of_range("rate", value),
            "{value} Hz in f32"
        );
    }
    for value in [dec!(4.001), ratio(60, 1), dec!(59.7275), ratio(100_000, 1)] {
        assert_eq!(Step::<I16F16>::hz(value).err(), None);
        assert_eq!(Step::<f32>::hz(value).err(), None);
    }
    let beyond = ratio(1 << 62, 1);
    assert_eq!(
        Step::<I16F16>::hz(beyond).err(),
        out_of_range("rate", beyond)
    );
    let absurd = ratio(1 << 40, 1);
    assert_eq!(
        Step::<I16F16>::hz(absurd).err(),
        out_of_range("rate", absurd)
    );
}

#[test]
fn lengths_of_time() {
    for value in [ratio(0, 1), ratio(-1, 60)] {
        assert_eq!(
            Step::<I16F16>::from_seconds(value).err(),
            not_positive("seconds", value)
        );
    }
    for value in [ratio(1, 4), dec!(0.26), ratio(60, 1), ratio(1, 1 << 62)] {
        assert_eq!(
            Step::<I16F16>::from_seconds(value).err(),
            out_of_range("seconds", value)
        );
    }
    let long = DyadicStep::<I16F16, { 1 << 24 }, 1>::new();
    assert_eq!(long.err(), None);
    assert_eq!(DyadicStep::<f32, { 1 << 24 }, 1>::new().err(), None);
}

#[test]
fn coefficients() {
    let (id, here) = (some_id(), Vec2::ZERO);
    let drag = |value: Ratio| LinearDrag::<I16F16>::new(value).err();
    let stiff = |value: Ratio| Anchor::<I16F16>::new(id, here, value, 0).err();
    let damped = |value: Ratio| Anchor::<I16F16>::new(id, here, 1, value).err();
    let spring = |value: Ratio| Spring::<I16F16>::new(1, value, 0).err();
    let brake = |value: Ratio| Spring::<I16F16>::new(1, 1, value).err();
    type Refusal<'a> = &'a dyn Fn(Ratio) -> Option<Error>;
    let all: [(&str, Refusal); 5] = [
        ("drag", &drag),
        ("stiffness", &stiff),
        ("damping", &damped),
        ("stiffness", &spring),
        ("damping", &brake),
    ];
    for (field, refusal) in all {
        for value in [dec!(-0.1), ratio(-1, 1 << 62), ratio(-(1 << 62), 1)] {
            assert_eq!(refusal(value), negative(field, value));
        }
        for value in [ratio(1 << 31, 1), ratio(1 << 62, 1)] {
            assert_eq!(refusal(value), out_of_range(field, value));
        }
        for value in [ratio(1, 1 << 34), ratio(1, 1 << 62)] {
            assert_eq!(refusal(value), rounds_to_zero(field, value));
        }
        for value in [ratio(0, 1), ratio(1, 1 << 31), ratio(1 << 29, 1)] {
            assert_eq!(refusal(value), None);
        }
    }
}

#[test]
fn rest_lengths() {
    let spring = |value: Ratio| Spring::<I16F16>::new(value, 1, 0).err();
    assert_eq!(spring(dec!(-0.5)), negative("rest_length", dec!(-0.5)));
    assert_eq!(
        spring(ratio(40_000, 1)),
        out_of_range("rest_length", ratio(40_000, 1))
    );
    assert_eq!(spring(ratio(0, 1)), None);
}

#[test]
fn vectors() {
    let large = ratio(40_000, 1);
    assert_eq!(
        vec2::<I16F16>(large, 0),
        Err(Error::OutOfRange {
            field: "x",
            value: large
        })
    );
    assert_eq!(
        vec2::<I16F16>(0, large),
        Err(Error::OutOfRange {
            field: "y",
            value: large
        })
    );
    assert!(vec2::<I8F24>(128, 0).is_err() && vec2::<I8F24>(127, -127).is_ok());
    assert!(vec2::<I1F31>(1, 0).is_err() && vec2::<I1F31>(dec!(0.5), dec!(-0.999)).is_ok());
    assert_eq!(vec2::<f32>(large, 0), Ok(Vec2::new(40_000.0, 0.0)));
}
