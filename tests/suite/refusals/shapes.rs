//! Shapes and mass properties that are refused.

use fixstep::mass::{capsule, convex_polygon, disc, polygon, rectangle, ring};
use fixstep::{MassProperties, Shape};

use super::*;

/// What each shape says to a length, by the name of its argument.
fn all(length: Ratio, error: fn(&'static str, Ratio) -> Error) -> Errors {
    vec![
        exact(disc::<f32>(length), error("radius", length)),
        exact(ring::<f32>(length, 0), error("outer", length)),
        exact(rectangle::<f32>(length, 1), error("width", length)),
        exact(capsule::<f32>(0, length), error("radius", length)),
    ]
}

pub fn of_no_length() -> Errors {
    let height = exact(rectangle::<f32>(1, 0), not_positive("height", dec!(0)));
    [
        all(dec!(0), not_positive),
        all(dec!(-3), not_positive),
        vec![height],
    ]
    .concat()
}

pub fn too_large() -> Errors {
    let large = dec!(10_000_000_000);
    let mut errors = all(large, out_of_range);
    errors.push(exact(
        rectangle::<f32>(1, large),
        out_of_range("height", large),
    ));
    errors.push(exact(
        capsule::<f32>(large, 1),
        out_of_range("length", large),
    ));
    errors
}

pub fn too_small() -> Errors {
    let tiny = dec!(0.0000000001);
    vec![
        exact(disc::<f32>(tiny), rounds_to_zero("radius", tiny)),
        exact(ring::<f32>(tiny, tiny), rounds_to_zero("outer", tiny)),
        exact(rectangle::<f32>(tiny, tiny), rounds_to_zero("width", tiny)),
        exact(capsule::<f32>(0, tiny), rounds_to_zero("radius", tiny)),
    ]
}

pub fn below_zero() -> Errors {
    let below = dec!(-0.1);
    vec![
        exact(ring::<f32>(1, below), negative("inner", below)),
        exact(capsule::<f32>(below, 1), negative("length", below)),
    ]
}

pub fn inside_out() -> Errors {
    let more = dec!(1.000000001);
    vec![exact(ring::<f32>(1, more), out_of_range("inner", more))]
}

fn outlines<const N: usize>(corners: [(f32, f32); N]) -> Errors {
    let corners = corners.map(|(x, y)| Vec2::new(x, y));
    vec![
        refused(polygon(&corners)),
        refused(convex_polygon(&corners)),
    ]
}

pub fn no_vertices() -> Errors {
    outlines([])
}

pub fn vertices_not_finite() -> Errors {
    [f32::NAN, f32::INFINITY, 1e20]
        .map(|bad| outlines([(0.0, 0.0), (bad, 0.0), (0.0, 1.0)]))
        .concat()
}

pub fn without_area() -> Errors {
    let line = outlines([(0.0, 0.0), (1.0, 1.0), (3.0, 3.0)]);
    let lobes = outlines([(0.0, 0.0), (2.0, 2.0), (2.0, 0.0), (0.0, 2.0)]);
    [line, lobes, outlines([(0.0, 0.0), (1.0, 0.0)])].concat()
}

pub fn not_convex() -> Errors {
    let corner = |(x, y): (f32, f32)| Vec2::new(x, y);
    let dent = [(0.0, 0.0), (4.0, 0.0), (1.0, 1.0), (0.0, 4.0)].map(corner);
    let straight = [(0.0, 0.0), (4.0, 0.0), (8.0, 0.0), (0.0, 4.0)].map(corner);
    let star = [
        (0.0, 10.0),
        (-6.0, -8.0),
        (10.0, 3.0),
        (-10.0, 3.0),
        (6.0, -8.0),
    ]
    .map(corner);
    vec![
        refused(convex_polygon(&dent)),
        refused(convex_polygon(&straight)),
        refused(convex_polygon(&star)),
    ]
}

fn plate() -> Shape<f32> {
    disc(dec!(0.5)).unwrap()
}

pub fn of_no_mass() -> Errors {
    let hoop = ring::<f32>(1, 1).unwrap().with_density(1);
    let mut errors = vec![exact(hoop, not_positive("area", dec!(0)))];
    for value in [dec!(0), dec!(-2)] {
        errors.push(exact(plate().with_mass(value), not_positive("mass", value)));
        errors.push(exact(
            plate().with_density(value),
            not_positive("density", value),
        ));
    }
    errors
}

pub fn too_heavy() -> Errors {
    let (large, disc) = (ratio(1 << 62, 1), disc::<f32>(2).unwrap());
    vec![
        exact(disc.with_mass(large), out_of_range("mass", large)),
        exact(disc.with_density(large), out_of_range("density", large)),
    ]
}

pub fn too_light() -> Errors {
    let tiny = ratio(1, 1 << 62);
    let small = disc::<f32>(dec!(0.1)).unwrap();
    vec![
        exact(small.with_mass(tiny), rounds_to_zero("mass", tiny)),
        refused(plate().with_density(tiny)),
    ]
}

pub fn known_of_no_mass() -> Errors {
    let of = |mass| {
        exact(
            MassProperties::<f32>::new(mass, Vec2::ZERO, 1),
            not_positive("mass", mass),
        )
    };
    [dec!(0), dec!(-2)].map(of).into()
}

pub fn inertia_below_zero() -> Errors {
    let below = dec!(-1);
    vec![exact(
        MassProperties::<f32>::new(1, Vec2::ZERO, below),
        negative("inertia", below),
    )]
}

pub fn places() -> Errors {
    let body = plate().with_mass(1).unwrap();
    let mut errors = Errors::new();
    for bad in [f32::NAN, f32::INFINITY] {
        let bad = Vec2::new(0.0, bad);
        errors.extend([
            exact(MassProperties::new(1, bad, 1), not_finite("centre")),
            exact(body.at(bad), not_finite("position")),
            exact(body.inertia_about(bad), not_finite("point")),
        ]);
    }
    let far = Vec2::new(1e10, 0.0);
    errors.push(exact(body.inertia_about(far), not_finite("point")));
    let edge = MassProperties::<I8F24>::new(1, vec2(100, 0).unwrap(), 1).unwrap();
    errors.push(exact(edge.at(edge.centre()), not_finite("position")));
    errors
}

pub fn no_parts() -> Errors {
    vec![
        exact(
            MassProperties::<f32>::from_parts(&[]),
            Error::Empty { field: "parts" },
        ),
        exact(
            MassProperties::<f32>::from_points(&[]),
            Error::Empty { field: "points" },
        ),
    ]
}

pub fn sums_beyond() -> Errors {
    let mass = Ratio::new(1 << 61, 1).unwrap();
    let heavy = MassProperties::new(mass, Vec2::new(1000.0_f32, 0.0), 0).unwrap();
    let light = MassProperties::new(1, Vec2::new(-1000.0_f32, 0.0), 0).unwrap();
    let position = Vec2::new(1e20_f32, 0.0);
    let point = PointMass {
        position,
        velocity: Vec2::ZERO,
        mass: dec!(1),
    };
    vec![
        refused(MassProperties::from_parts(&[heavy, heavy])),
        refused(MassProperties::from_points(&[point])),
        refused(heavy.without(&light)),
    ]
}

pub fn holes() -> Errors {
    let plate = disc::<f32>(1).unwrap().with_mass(2).unwrap();
    let heavy = disc::<f32>(dec!(0.1)).unwrap();
    let wide = ring::<f32>(2, 2).unwrap().with_mass(1).unwrap();
    let outside = heavy.with_mass(1).unwrap().at(vec2(5, 0).unwrap()).unwrap();
    let hole = |mass| plate.without(&heavy.with_mass(mass).unwrap());
    vec![
        exact(hole(dec!(2)), out_of_range("hole", dec!(2))),
        exact(hole(dec!(3)), out_of_range("hole", dec!(3))),
        // Lighter, but wider: 1 kg at 2 m is more than 1 kg m². So is a small one that lies outside.
        exact(plate.without(&wide), out_of_range("hole", dec!(4))),
        exact(plate.without(&outside), out_of_range("hole", dec!(0.005))),
    ]
}
