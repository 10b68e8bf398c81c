//! Shapes and mass properties that are refused. `tests/shape/refused.rs` has fields and values.

use fixstep::mass::{capsule, convex_polygon, disc, polygon, rectangle, ring};
use fixstep::{MassProperties, Shape};

use super::*;

/// What each shape says to a length, for the lengths that it calls so.
fn all(length: Ratio) -> Errors {
    vec![
        refused(disc::<f32>(length)),
        refused(ring::<f32>(length, 0)),
        refused(rectangle::<f32>(length, length)),
        refused(capsule::<f32>(0, length)),
    ]
}

pub fn of_no_length() -> Errors {
    [all(dec!(0)), all(dec!(-3))].concat()
}

pub fn too_large() -> Errors {
    all(dec!(10_000_000_000))
}

pub fn too_small() -> Errors {
    all(dec!(0.0000000001))
}

pub fn below_zero() -> Errors {
    let below = dec!(-0.1);
    vec![
        refused(ring::<f32>(1, below)),
        refused(capsule::<f32>(below, 1)),
    ]
}

pub fn inside_out() -> Errors {
    vec![refused(ring::<f32>(1, 2))]
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
    vec![
        refused(plate().with_mass(0)),
        refused(plate().with_density(-1)),
        refused(ring::<f32>(1, 1).unwrap().with_density(1)),
    ]
}

pub fn too_heavy() -> Errors {
    let (large, disc) = (Ratio::new(1 << 62, 1).unwrap(), disc::<f32>(2).unwrap());
    vec![
        refused(disc.with_mass(large)),
        refused(disc.with_density(large)),
    ]
}

pub fn too_light() -> Errors {
    let tiny = Ratio::new(1, 1 << 62).unwrap();
    vec![
        refused(plate().with_mass(tiny)),
        refused(plate().with_density(tiny)),
    ]
}

pub fn known_of_no_mass() -> Errors {
    vec![refused(MassProperties::<f32>::new(0, Vec2::ZERO, 1))]
}

pub fn inertia_below_zero() -> Errors {
    vec![refused(MassProperties::<f32>::new(1, Vec2::ZERO, -1))]
}

pub fn places() -> Errors {
    let body = plate().with_mass(1).unwrap();
    let bad = Vec2::new(f32::NAN, 0.0);
    let far = MassProperties::<I8F24>::new(1, vec2(100, 0).unwrap(), 1).unwrap();
    vec![
        refused(MassProperties::new(1, bad, 1)),
        refused(body.at(bad)),
        refused(far.at(far.centre())),
        refused(body.inertia_about(bad)),
    ]
}

pub fn no_parts() -> Errors {
    vec![
        refused(MassProperties::<f32>::from_parts(&[])),
        refused(MassProperties::<f32>::from_points(&[])),
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
    let body = plate().with_mass(1).unwrap();
    let wide = ring::<f32>(2, 2).unwrap().with_mass(dec!(0.5)).unwrap();
    vec![refused(body.without(&body)), refused(body.without(&wide))]
}
