//! Lengths, masses, places and holes that are refused, each by its name.

use fixstep::fixed::types::I8F24;
use fixstep::mass::{capsule, disc, rectangle, ring};
use fixstep::{Error, MassProperties, PointMass, Ratio, Vec2, dec, vec2};

#[test]
fn lengths() {
    let not_positive = |field, value| Err(Error::NotPositive { field, value });
    let negative = |field, value| Err(Error::Negative { field, value });
    let (zero, below, large, tiny) = (dec!(0), dec!(-1), dec!(10_000_000_000), dec!(0.0000000001));
    for value in [zero, below] {
        assert_eq!(disc::<f32>(value), not_positive("radius", value));
        assert_eq!(ring::<f32>(value, 1), not_positive("outer", value));
        assert_eq!(rectangle::<f32>(value, 1), not_positive("width", value));
        assert_eq!(rectangle::<f32>(1, value), not_positive("height", value));
        assert_eq!(capsule::<f32>(1, value), not_positive("radius", value));
    }
    assert_eq!(ring::<f32>(1, below), negative("inner", below));
    assert_eq!(capsule::<f32>(below, 1), negative("length", below));
    let beyond = |field, value| Err(Error::OutOfRange { field, value });
    let more = dec!(1.000000001);
    assert_eq!(ring::<f32>(1, more), beyond("inner", more));
    assert_eq!(disc::<f32>(large), beyond("radius", large));
    assert_eq!(ring::<f32>(large, 1), beyond("outer", large));
    assert_eq!(rectangle::<f32>(large, 1), beyond("width", large));
    assert_eq!(rectangle::<f32>(1, large), beyond("height", large));
    assert_eq!(capsule::<f32>(1, large), beyond("radius", large));
    assert_eq!(capsule::<f32>(large, 1), beyond("length", large));
    let lost = |field, value| Err(Error::RoundsToZero { field, value });
    assert_eq!(disc::<f32>(tiny), lost("radius", tiny));
    assert_eq!(ring::<f32>(tiny, tiny), lost("outer", tiny));
    assert_eq!(rectangle::<f32>(tiny, tiny), lost("width", tiny));
    assert_eq!(capsule::<f32>(0, tiny), lost("radius", tiny));
}

#[test]
fn masses_parts_and_places() {
    let (plate, hoop) = (disc::<f32>(1).unwrap(), ring::<f32>(1, 1).unwrap());
    for value in [dec!(0), dec!(-2)] {
        let refused = |field| Err(Error::NotPositive { field, value });
        assert_eq!(plate.with_mass(value), refused("mass"));
        assert_eq!(plate.with_density(value), refused("density"));
        assert_eq!(
            MassProperties::<f32>::new(value, Vec2::ZERO, 1),
            refused("mass")
        );
    }
    let (field, value) = ("area", Ratio::ZERO);
    assert_eq!(
        hoop.with_density(1),
        Err(Error::NotPositive { field, value })
    );
    let value = Ratio::new(1 << 62, 1).unwrap();
    let beyond = |field| Err(Error::OutOfRange { field, value });
    assert_eq!(plate.with_density(value), beyond("density"));
    assert_eq!(disc::<f32>(2).unwrap().with_mass(value), beyond("mass"));
    let (field, value) = ("mass", Ratio::new(1, 1 << 62).unwrap());
    let small = disc::<f32>(dec!(0.1)).unwrap();
    assert_eq!(
        small.with_mass(value),
        Err(Error::RoundsToZero { field, value })
    );
    let (field, value) = ("inertia", dec!(-1));
    let below = MassProperties::<f32>::new(1, Vec2::ZERO, value);
    assert_eq!(below, Err(Error::Negative { field, value }));
    assert_eq!(
        MassProperties::<f32>::from_parts(&[]),
        Err(Error::Empty { field: "parts" })
    );
    assert_eq!(
        MassProperties::<f32>::from_points(&[]),
        Err(Error::Empty { field: "points" })
    );
}

#[test]
fn places() {
    let body = disc::<f32>(1).unwrap().with_mass(1).unwrap();
    let refused = |field| Error::NotFinite { field };
    for bad in [f32::NAN, f32::INFINITY] {
        let bad = Vec2::new(0.0, bad);
        assert_eq!(body.at(bad), Err(refused("position")));
        assert_eq!(body.inertia_about(bad), Err(refused("point")));
        assert_eq!(MassProperties::new(1, bad, 1), Err(refused("centre")));
        let point = PointMass {
            position: bad,
            velocity: Vec2::ZERO,
            mass: dec!(1),
        };
        assert_eq!(
            MassProperties::from_points(&[point]),
            Err(refused("position"))
        );
    }
    let far = Vec2::new(1e10, 0.0);
    assert_eq!(body.inertia_about(far), Err(refused("point")));
    let there = body.at(far).unwrap();
    assert_eq!(
        MassProperties::from_parts(&[body, there]),
        Err(refused("parts"))
    );
    let edge = disc::<I8F24>(1).unwrap().with_mass(1).unwrap();
    let edge = edge.at(vec2(100, 0).unwrap()).unwrap();
    assert_eq!(edge.at(vec2(100, 0).unwrap()), Err(refused("position")));
}

#[test]
fn holes() {
    let plate = disc::<f32>(1).unwrap().with_mass(2).unwrap();
    let refused = |value| {
        Err(Error::OutOfRange {
            field: "hole",
            value,
        })
    };
    let heavy = disc::<f32>(dec!(0.1)).unwrap();
    for mass in [dec!(2), dec!(3)] {
        assert_eq!(
            plate.without(&heavy.with_mass(mass).unwrap()),
            refused(mass)
        );
    }
    // Lighter, but wider: 1 kg at 2 m is more than 1 kg m². So is a small one that lies outside.
    let wide = ring::<f32>(2, 2).unwrap().with_mass(1).unwrap();
    assert_eq!(plate.without(&wide), refused(dec!(4)));
    let outside = heavy.with_mass(1).unwrap().at(vec2(5, 0).unwrap()).unwrap();
    assert_eq!(plate.without(&outside), refused(dec!(0.005)));
}
