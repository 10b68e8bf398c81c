//! Mass properties of shapes against closed forms, quadratures and triangles in `f64` or whole numbers.
//!
//! A fraction is off by some `2^-60` of itself, so what is seen here is the reference: ten roundings of
//! `2^-53` each, 1.2e-15, and as many more where a closed form has longer sums. The bound is
//! [`ROUNDED`], twice that.

#[path = "shape/compounds.rs"]
mod compounds;
#[path = "shape/gears.rs"]
mod gears;
#[path = "shape/outlines.rs"]
mod outlines;
#[path = "shape/polygons.rs"]
mod polygons;
use crate::support;

use std::f64::consts::PI;

use fixstep::mass::{capsule, disc, rectangle, ring};
use fixstep::{Ratio, Shape, dec};

/// Twenty roundings of an `f64`.
const ROUNDED: f64 = 20.0 / (1_u64 << 53) as f64;

/// Lengths from a tenth of a millimetre to 30 km, as decimals and as fractions of two.
const LENGTHS: [Ratio; 6] = [
    dec!(0.0001),
    dec!(0.001),
    dec!(0.45),
    dec!(1),
    dec!(1234.5678),
    dec!(32767.99998474121),
];

fn near(told: Ratio, wanted: f64, bound: f64, what: &str) {
    let error = (told.to_f64() / wanted - 1.0).abs();
    assert!(
        error <= bound,
        "{what}: {told} for {wanted:e}, off by {error:e}"
    );
}

fn measures(shape: Shape<f32>, area: f64, inertia_per_mass: f64, what: &str) {
    near(shape.area(), area, ROUNDED, what);
    near(shape.inertia_per_mass(), inertia_per_mass, ROUNDED, what);
    let body = shape.with_density(dec!(2.5)).unwrap();
    near(body.mass(), 2.5 * area, ROUNDED, what);
    near(body.inertia(), 2.5 * area * inertia_per_mass, ROUNDED, what);
    let body = shape.with_mass(dec!(0.3)).unwrap();
    assert_eq!((body.mass(), body.centre()), (dec!(0.3), shape.centre()));
    near(body.inertia(), 0.3 * inertia_per_mass, ROUNDED, what);
}

#[test]
fn discs() {
    for radius in LENGTHS {
        let r = radius.to_f64();
        measures(disc(radius).unwrap(), PI * r * r, r * r / 2.0, "disc");
    }
}

// The width of the narrowest is a thousandth of the radius: the reference must not make it by a
// difference.
#[test]
fn rings() {
    for outer in LENGTHS {
        for thousandths in [0, 250, 500, 999] {
            let inner = Ratio::new(outer.num() * thousandths, outer.den() * 1000).unwrap();
            let [big, small] = [outer, inner].map(Ratio::to_f64);
            let width = big * (1000 - thousandths) as f64 / 1000.0;
            let per_mass = (big * big + small * small) / 2.0;
            let area = PI * width * (big + small);
            measures(ring(outer, inner).unwrap(), area, per_mass, "ring");
        }
        let (hoop, r) = (ring::<f32>(outer, outer).unwrap(), outer.to_f64());
        assert_eq!(hoop.area(), Ratio::ZERO);
        near(hoop.inertia_per_mass(), r * r, ROUNDED, "hoop");
    }
}

#[test]
fn rectangles() {
    for width in LENGTHS {
        for height in LENGTHS {
            let [w, h] = [width, height].map(Ratio::to_f64);
            let shape = rectangle(width, height).unwrap();
            measures(shape, w * h, (w * w + h * h) / 12.0, "rectangle");
        }
    }
}

/// Area and inertia per mass of a capsule by Gauss-Legendre quadrature with three points, of chords
/// of the round ends over the angle: x = L/2 + r sin a, half chord r cos a. With 400 strips each of
/// `(π / 800)` rad the error of a strip is below `(π/800)^6 / 2016000` of it times a sixth derivative
/// of at most 6^6: under 1e-16 in all.
fn capsule_by_strips(l: f64, r: f64) -> [f64; 2] {
    let strips = 400;
    let (mut area, mut inertia) = (0.0, 0.0);
    let nodes = [
        (-0.6_f64.sqrt(), 5.0 / 18.0),
        (0.0, 8.0 / 18.0),
        (0.6_f64.sqrt(), 5.0 / 18.0),
    ];
    for strip in 0..strips {
        let width = PI / 2.0 / strips as f64;
        for (node, weight) in nodes {
            let angle = width * (strip as f64 + 0.5 + node / 2.0);
            let (x, y) = (l / 2.0 + r * angle.sin(), r * angle.cos());
            let dx = weight * width * r * angle.cos();
            // Both ends, above and below: four chords of y.
            area += 4.0 * y * dx;
            inertia += 4.0 * (x * x * y + y * y * y / 3.0) * dx;
        }
    }
    let straight = 2.0 * r * l;
    area += straight;
    inertia += straight * (l * l + 4.0 * r * r) / 12.0;
    [area, inertia / area]
}

// Sums of 1200 positive terms: each addition is off by 2^-53 of the sum at most, 1.4e-13 in all.
#[test]
fn capsules() {
    let bound = 1300.0 / (1_u64 << 53) as f64;
    for length in [dec!(0), dec!(0.001), dec!(0.45), dec!(100), dec!(30000)] {
        for radius in LENGTHS {
            let [area, per_mass] = capsule_by_strips(length.to_f64(), radius.to_f64());
            let pill: Shape<f32> = capsule(length, radius).unwrap();
            near(pill.area(), area, bound, "area of a capsule");
            near(pill.inertia_per_mass(), per_mass, bound, "capsule");
        }
    }
}
