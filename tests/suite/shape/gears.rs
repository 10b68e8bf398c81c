//! A gear with a bore, and regular polygons on their way to a disc.

use std::f64::consts::{PI, TAU};

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::mass::{convex_polygon, disc, polygon};
use fixstep::{Error, Rational, Vec2, dec};

use super::near;
use super::polygons::by_triangles;
use super::support::{Format, vector};

/// Four corners a tooth: foot, tip, tip, foot.
fn outline<S: Rational>(teeth: usize, tip: f64, foot: f64) -> Vec<Vec2<S>> {
    let corner = |i: usize| {
        let radius = if matches!(i % 4, 1 | 2) { tip } else { foot };
        let angle = TAU * (i as f64 + 0.1) / (4 * teeth) as f64;
        vector(radius * angle.cos(), radius * angle.sin())
    };
    (0..4 * teeth).map(corner).collect()
}

// Mass and inertia are those of the triangles less those of the bore. The triangles lose 96 roundings, 1.1e-14, of
// which a tenth is cut; the corners of f64 are rounded to 2^-41 of the box. Corners that are rounded
// put the centre of the teeth beside that of the bore, by less than a unit of the type: the gear
// turns about one between, and has less inertia by no more than that, squared, over that of 6 cm.
fn has_teeth_and_a_bore<S: Format + Rational>(teeth: usize) {
    let bound = match size_of::<S>() {
        4 => 96.0 * 2.0_f64.powi(-53),
        _ => 16.0 * 2.0_f64.powi(-41),
    };
    let (corners, steel) = (outline::<S>(teeth, 0.1, 0.08), dec!(78));
    let within: Vec<_> = corners
        .iter()
        .map(|v| [v.x.to_f64(), v.y.to_f64()])
        .collect();
    let [area, per_mass] = by_triangles(&within);
    let [mass, hole] = [78.0 * area, 78.0 * PI * 0.02 * 0.02];
    let inertia = mass * per_mass - hole * 0.02 * 0.02 / 2.0;

    let bore = disc(dec!(0.02)).unwrap().with_density(steel).unwrap();
    let blank = polygon(&corners).unwrap().with_density(steel).unwrap();
    let gear = blank.without(&bore).unwrap();
    near(blank.inertia(), mass * per_mass, bound, "blank");
    near(gear.mass(), mass - hole, bound, "gear");
    let beside = S::unit(0.0) / 0.06;
    near(gear.inertia(), inertia, beside * beside + bound, "gear");
    assert!(matches!(
        convex_polygon(&corners),
        Err(Error::NotConvex { .. })
    ));
}

#[test]
fn gears() {
    for teeth in [12, 17, 24] {
        has_teeth_and_a_bore::<I16F16>(teeth);
        has_teeth_and_a_bore::<I8F24>(teeth);
        has_teeth_and_a_bore::<f32>(teeth);
        has_teeth_and_a_bore::<f64>(teeth);
    }
}

// A = n/2 R² sin(2π/n), I / m = R² (2 + cos(2π/n)) / 6; both are those of a disc less a part
// 2π²/3n² and 4π²/6n² of it, with terms of n⁻⁴ behind.
#[test]
fn many_corners_make_a_disc() {
    let round = disc::<f64>(2).unwrap();
    for n in [6, 7, 100, 3000] {
        let corner = |i: usize| {
            let angle = TAU * i as f64 / n as f64;
            Vec2::new(2.0 * angle.cos(), 2.0 * angle.sin())
        };
        let corners: Vec<_> = (0..n).map(corner).collect();
        let (shape, part) = (convex_polygon(&corners).unwrap(), TAU / n as f64);
        let bound = 8.0 * 2.0_f64.powi(-41);
        near(shape.area(), 2.0 * n as f64 * part.sin(), bound, "area");
        near(
            shape.inertia_per_mass(),
            4.0 * (2.0 + part.cos()) / 6.0,
            bound,
            "inertia",
        );
        let less = part * part / 6.0;
        near(
            shape.area(),
            round.area().to_f64() * (1.0 - less),
            less * less + bound,
            "disc",
        );
        let per_mass = round.inertia_per_mass().to_f64();
        near(
            shape.inertia_per_mass(),
            per_mass * (1.0 - less),
            less * less + bound,
            "disc",
        );
    }
}
