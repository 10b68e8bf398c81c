//! Bodies of parts, with holes, and of points.

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::mass::{capsule, disc, polygon, rectangle, ring};
use fixstep::{CentreOfMass, MassProperties, PointMass, Ratio, Rational, Vec2, dec, vec2};

use super::support::{Random, scalar, vector};
use super::{ROUNDED, near};

fn at<S: Rational>(part: MassProperties<S>, x: Ratio, y: Ratio) -> MassProperties<S> {
    part.at(vec2(x, y).unwrap()).unwrap()
}

fn ratio(num: i64, den: u64) -> Ratio {
    Ratio::new(num, den).unwrap()
}

// A rectangle of 6 by 2 from one of 2 by 2 and one of 4 by 2.
fn two_rectangles<S: Rational>() {
    let plate = |width| {
        rectangle::<S>(width, dec!(2))
            .unwrap()
            .with_density(dec!(0.3))
            .unwrap()
    };
    let parts = [
        at(plate(dec!(2)), dec!(-2), dec!(0)),
        at(plate(dec!(4)), dec!(1), dec!(0)),
    ];
    let whole = MassProperties::from_parts(&parts).unwrap();
    assert_eq!(whole, plate(dec!(6)));
    assert_eq!(whole.without(&parts[0]), Ok(parts[1]));
}

// Two discs of radius r and mass m, D apart: 2 m (r²/2 + D²/4).
fn dumb_bell<S: Rational>() {
    let ball = disc::<S>(dec!(0.25)).unwrap().with_mass(3).unwrap();
    let bell = [at(ball, dec!(-1.5), dec!(2)), at(ball, dec!(1.5), dec!(2))];
    let bell = MassProperties::from_parts(&bell).unwrap();
    assert_eq!((bell.mass(), bell.centre()), (dec!(6), vec2(0, 2).unwrap()));
    assert_eq!(bell.inertia(), dec!(13.6875));
    assert_eq!(bell.inertia_about(Vec2::ZERO), Ok(dec!(37.6875)));
}

// π is a fraction, so that a ring is the difference of two discs to the last bit.
fn ring_from_discs<S: Rational>() {
    let plate = |radius| disc::<S>(radius).unwrap().with_density(2).unwrap();
    let cut = plate(dec!(1)).without(&plate(dec!(0.75))).unwrap();
    let whole = ring::<S>(1, dec!(0.75)).unwrap().with_density(2).unwrap();
    near(cut.mass(), whole.mass().to_f64(), ROUNDED, "ring");
    near(cut.inertia(), whole.inertia().to_f64(), ROUNDED, "ring");
    assert_eq!(cut.centre(), Vec2::ZERO);
    // An eccentric hole: I - m r²/2 - m d² about the old centre, less M c² for the new one.
    let hole = at(plate(dec!(0.25)), dec!(0.5), dec!(-0.5));
    let cam = plate(dec!(1)).without(&hole).unwrap();
    let unit = std::f64::consts::PI * 2.0;
    let [all, gone] = [unit, unit / 16.0];
    let centre = -0.5 * gone / (all - gone);
    let inertia = all / 2.0 - gone * (0.5 + 1.0 / 32.0) - (all - gone) * 2.0 * centre * centre;
    near(cam.inertia(), inertia, ROUNDED, "cam");
    assert_eq!(cam.centre(), vector(centre, -centre));
}

#[test]
fn parts_and_holes() {
    macro_rules! each {
        ($($scalar:ident)*) => {$(
            two_rectangles::<$scalar>();
            dumb_bell::<$scalar>();
            ring_from_discs::<$scalar>();
        )*};
    }
    each!(I16F16 I8F24 f32 f64);
}

// A polygon of 2 by 2000 corners for the two round ends: k² of a disc's polygon is low by
// 2π²/3n² of itself, 4.1e-7 for n = 4000, an area by as much; both at most double in a compound.
#[test]
fn a_capsule_is_a_polygon_with_round_ends() {
    let (half, n) = (0.75, 2000);
    let corner = |i: usize| {
        let angle = std::f64::consts::PI * (i % n) as f64 / (n - 1) as f64;
        let side = if i < n { 1.0 } else { -1.0 };
        Vec2::new(side * (half + 0.5 * angle.sin()), -side * 0.5 * angle.cos())
    };
    let outline: Vec<_> = (0..2 * n).map(corner).collect();
    let (outline, pill) = (
        polygon(&outline).unwrap(),
        capsule::<f64>(dec!(1.5), dec!(0.5)).unwrap(),
    );
    near(outline.area(), pill.area().to_f64(), 1e-6, "area");
    near(
        outline.inertia_per_mass(),
        pill.inertia_per_mass().to_f64(),
        1e-6,
        "capsule",
    );
}

/// Twenty points on whole units of `2^-16` m within half a metre, with whole grams.
fn points<S: Rational>(random: &mut Random) -> (Vec<PointMass<S>>, Vec<[i128; 3]>) {
    let place = |bits: u64| (bits % (1 << 16)) as i128 - (1 << 15);
    let whole: Vec<_> = (0..20)
        .map(|_| {
            [
                place(random.next()),
                place(random.next()),
                (random.next() % 5000) as i128 + 1,
            ]
        })
        .collect();
    let metres = |units: i128| scalar::<S>(units as f64 / 65_536.0);
    let point = |&[x, y, grams]: &[i128; 3]| PointMass {
        position: Vec2::new(metres(x), metres(y)),
        velocity: Vec2::ZERO,
        mass: ratio(grams as i64, 1000),
    };
    (whole.iter().map(point).collect(), whole)
}

// I = sum(m r²) - |sum(m r)|² / M, in whole numbers but for the last division. Thirty fractions
// round by 2^-60.
fn set_of_points<S: Rational>(unit: f64) {
    let mut random = Random(5);
    for _ in 0..20 {
        let (points, whole) = points::<S>(&mut random);
        let sum = |f: &dyn Fn(&[i128; 3]) -> i128| whole.iter().map(f).sum::<i128>();
        let (mass, x, y) = (sum(&|p| p[2]), sum(&|p| p[2] * p[0]), sum(&|p| p[2] * p[1]));
        let about_origin = sum(&|p| p[2] * (p[0] * p[0] + p[1] * p[1]));
        let scale = 1000.0 * 2.0_f64.powi(32) * mass as f64;
        let inertia = (about_origin * mass - x * x - y * y) as f64 / scale;
        let body = MassProperties::from_points(&points).unwrap();
        assert_eq!(body.mass(), ratio(mass as i64, 1000));
        near(body.inertia(), inertia, ROUNDED, "points");
        let known = CentreOfMass::new(&points).unwrap();
        assert_eq!(known.mass, body.mass());
        let wanted = [x, y].map(|sum| sum as f64 / mass as f64 / 65_536.0);
        let told = body.centre().to_f64();
        // Half a unit, and as much for the reference where a float's unit is that of its own.
        let off = (told.x - wanted[0]).abs().max((told.y - wanted[1]).abs());
        assert!(off <= 0.51 * unit, "{off:e}");
    }
}

#[test]
fn point_masses() {
    set_of_points::<I16F16>(2.0_f64.powi(-16));
    set_of_points::<I8F24>(2.0_f64.powi(-24));
    set_of_points::<f32>(2.0_f64.powi(-25));
    set_of_points::<f64>(2.0_f64.powi(-53));
}
