//! Polygons against triangles: whole numbers where all is exact, `f64` elsewhere.
//!
//! The reference knows triangles only: area by a cross product, inertia about the own centroid from
//! the sides, `(a² + b² + c²) / 36` of the mass, and parallel axes. A fan about the origin counts
//! triangles that turn right as holes.

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::mass::{convex_polygon, polygon};
use fixstep::{Ratio, Rational, Scalar, Shape, Vec2};

use super::support::{Random, scalar, spread};

/// What the triangles of a fan about the origin amount to: area and inertia per mass.
pub fn by_triangles(corners: &[[f64; 2]]) -> [f64; 2] {
    let minus = |a: [f64; 2], b: [f64; 2]| [a[0] - b[0], a[1] - b[1]];
    let square = |a: [f64; 2]| a[0] * a[0] + a[1] * a[1];
    let (mut area, mut inertia, mut moment) = (0.0, 0.0, [0.0; 2]);
    for (i, &a) in corners.iter().enumerate() {
        let b = corners[(i + 1) % corners.len()];
        let part = (a[0] * b[1] - a[1] * b[0]) / 2.0;
        let own = (square(a) + square(b) + square(minus(a, b))) / 36.0;
        let centre = [(a[0] + b[0]) / 3.0, (a[1] + b[1]) / 3.0];
        area += part;
        moment = [moment[0] + part * centre[0], moment[1] + part * centre[1]];
        inertia += part * (own + square(centre));
    }
    [area, inertia / area - square(moment) / (area * area)]
}

/// The same of whole numbers, exactly, in units of `2^-10` m: `[2 A, k² num, k² den]`.
fn in_whole_numbers(corners: &[[i64; 2]]) -> [i64; 3] {
    let square = |x: i64, y: i64| x * x + y * y;
    let (mut twice, mut inertia, mut moment) = (0, 0, [0; 2]);
    for (i, &[ax, ay]) in corners.iter().enumerate() {
        let [bx, by] = corners[(i + 1) % corners.len()];
        let part = ax * by - ay * bx;
        let sides = square(ax, ay) + square(bx, by) + square(bx - ax, by - ay);
        twice += part;
        moment = [moment[0] + part * (ax + bx), moment[1] + part * (ay + by)];
        inertia += part * (sides + 4 * square(ax + bx, ay + by));
    }
    let (num, den) = (
        inertia * twice - 4 * square(moment[0], moment[1]),
        36 * twice * twice,
    );
    [twice, num, den << 20]
}

fn outline<S: Scalar>(corners: &[[i64; 2]]) -> Vec<Vec2<S>> {
    let metres = |units: i64| S::ratio(Ratio::new(units, 1 << 10).unwrap()).unwrap();
    let corner = |&[x, y]: &[i64; 2]| Vec2::new(metres(x), metres(y));
    corners.iter().map(corner).collect()
}

/// Random corners around the origin, up to 63 units off.
fn around(random: &mut Random, n: usize) -> Vec<[i64; 2]> {
    let corner = |i| {
        let angle = std::f64::consts::TAU * i as f64 / n as f64;
        let radius = 16.0 + (random.next() % 48) as f64;
        [angle.cos(), angle.sin()].map(|part| (radius * part).round() as i64)
    };
    (0..n).map(corner).collect()
}

fn is_exact<S: Rational>() {
    let mut random = Random(7);
    for n in [3, 4, 5, 8, 13] {
        for _ in 0..50 {
            let corners = around(&mut random, n);
            let [twice, num, den] = in_whole_numbers(&corners);
            let shape = polygon(&outline::<S>(&corners)).unwrap();
            assert_eq!(shape.area(), Ratio::new(twice, 1 << 21).unwrap());
            let per_mass = Ratio::new(num, den as u64).unwrap();
            assert_eq!(shape.inertia_per_mass(), per_mass, "{corners:?}");
        }
    }
}

#[test]
fn small_outlines_are_exact_in_every_type() {
    is_exact::<I16F16>();
    is_exact::<I8F24>();
    is_exact::<f32>();
    is_exact::<f64>();
}

type Bits<S> = ([i64; 2], [u64; 2], Vec2<S>);

fn bits<S: Rational>(shape: &Shape<S>) -> Bits<S> {
    let (area, per_mass) = (shape.area(), shape.inertia_per_mass());
    let nums = [area.num(), per_mass.num()];
    (nums, [area.den(), per_mass.den()], shape.centre())
}

/// The outline through `change`, which does `moved` to its centre.
fn same<S: Rational>(corners: &[Vec2<S>], change: fn(Vec2<S>) -> Vec2<S>) {
    let plain = bits(&polygon(corners).unwrap());
    let changed: Vec<_> = corners.iter().copied().map(change).collect();
    let wanted = (plain.0, plain.1, change(plain.2));
    assert_eq!(bits(&polygon(&changed).unwrap()), wanted, "{corners:?}");
}

// Corners with all the bits that the type has, so that sums are rounded somewhere.
fn has_its_symmetries<S: Rational>(size: f64) {
    for n in [3_usize, 7, 20] {
        let radius = |i: usize| size * (0.3 + 0.7 * spread(3 * i + n));
        let angle = |i: usize| std::f64::consts::TAU * (i as f64 + 0.4 * spread(i)) / n as f64;
        let corner = |i| {
            Vec2::new(
                scalar(radius(i) * angle(i).cos()),
                scalar(radius(i) * angle(i).sin()),
            )
        };
        let mut corners: Vec<Vec2<S>> = (0..n).map(corner).collect();
        same(&corners, |v| Vec2::new(v.y.negated(), v.x));
        same(&corners, |v| -v);
        same(&corners, |v| Vec2::new(v.x.negated(), v.y));
        same(&corners, |v| Vec2::new(v.y, v.x));
        let plain = bits(&polygon(&corners).unwrap());
        corners.rotate_left(n / 2);
        assert_eq!(bits(&polygon(&corners).unwrap()), plain);
        corners.reverse();
        assert_eq!(bits(&polygon(&corners).unwrap()), plain);
    }
}

#[test]
fn turned_mirrored_reversed_and_begun_elsewhere() {
    for size in [0.001, 1.0, 120.0] {
        has_its_symmetries::<I8F24>(size);
        has_its_symmetries::<I16F16>(250.0 * size);
        has_its_symmetries::<f32>(size);
        has_its_symmetries::<f64>(size);
    }
}

// 30 bits of offset: exact in fixed point and in f64; in f32 of so short corners up to 2^13 m. The
// centre is rounded where it lands: by half a unit here and there.
fn moves<S: Rational>(offset: f64, unit: f64) {
    let mut random = Random(11);
    let offset = Vec2::new(scalar::<S>(offset), scalar::<S>(-offset / 2.0));
    for n in [3, 6, 17] {
        let corners = outline::<S>(&around(&mut random, n));
        let there: Vec<_> = corners.iter().map(|&corner| corner + offset).collect();
        let (here, there) = (polygon(&corners).unwrap(), polygon(&there).unwrap());
        assert_eq!(
            (bits(&here).0, bits(&here).1),
            (bits(&there).0, bits(&there).1)
        );
        let off = (there.centre() - offset - here.centre()).to_f64();
        assert!(off.x.abs() <= unit && off.y.abs() <= unit, "{off:?}");
    }
}

#[test]
fn nothing_is_lost_far_from_the_origin() {
    moves::<I8F24>(127.5, 2.0_f64.powi(-24));
    moves::<I16F16>(32_700.0, 2.0_f64.powi(-16));
    moves::<f32>(8000.0, 2.0_f64.powi(-10));
    moves::<f64>(1e12, 2.0_f64.powi(-12));
}

/// Corners all around, of which every second lies inwards, `size` wide and at `offset`; against
/// triangles about a point within. Those lose up to n roundings of the box, `2^-53 n` of 8 times
/// the area; corners of more than 40 bits `2^-41` of the box, at 8 times the edge of a square.
fn is_near<S: Rational>(size: f64, offset: f64, bound: f64) {
    let n = 24;
    let middle = Vec2::new(scalar::<S>(offset), scalar::<S>(-offset));
    let corner = |i: usize| {
        let (radius, angle) = (
            size * [0.5, 0.3][i % 2],
            0.1 + i as f64 / n as f64 * std::f64::consts::TAU,
        );
        middle + Vec2::new(scalar(radius * angle.cos()), scalar(radius * angle.sin()))
    };
    let corners: Vec<Vec2<S>> = (0..n).map(corner).collect();
    let within = corners.iter().map(|&corner| {
        let from = corner - middle;
        [from.x.to_f64(), from.y.to_f64()]
    });
    let [area, per_mass] = by_triangles(&within.collect::<Vec<_>>());
    let star = polygon(&corners).unwrap();
    super::near(star.area(), area, bound, "area of a star");
    super::near(star.inertia_per_mass(), per_mass, bound, "star");
}

#[test]
fn stars_of_every_size() {
    let (plain, long) = (24.0 * 8.0 * 2.0_f64.powi(-53), 32.0 * 2.0_f64.powi(-41));
    for (size, offset) in [
        (0.001, 0.0),
        (0.001, 30_000.0),
        (1.0, 0.0),
        (1.0, -20_000.0),
        (65_000.0, 0.0),
    ] {
        is_near::<I16F16>(size, offset, plain);
    }
    for (size, offset) in [(0.001, 0.0), (0.001, 127.0), (1.0, -100.0), (255.0, 0.0)] {
        is_near::<I8F24>(size, offset, plain);
    }
    // Of corners near an axis the smaller coordinate has more bits: 2^-41 at most is lost there.
    for size in [0.001, 1.0, 1e6, 1e9] {
        is_near::<f32>(size, 0.0, long);
        is_near::<f64>(size, 0.0, long);
        is_near::<f64>(size, 1000.0 * size, long);
    }
    is_near::<f32>(1.0, 1000.0, long);
}

// A square that fills its box has the largest sums that an outline can have. Of k² only the last
// bits of the corners are lost.
#[test]
fn the_largest_sums_fit() {
    let edge = 1.0 - f64::EPSILON / 2.0;
    for size in [1.0, 1024.0, 2.0_f64.powi(29)] {
        let [left, right] = [-size * edge, size * (edge - f64::EPSILON)];
        let corner = |x, y| Vec2::new(x, y);
        let square = [
            corner(left, left),
            corner(right, left),
            corner(right, right),
            corner(left, right),
        ];
        let shape = convex_polygon(&square).unwrap();
        super::near(shape.area(), 4.0 * size * size, 2.0_f64.powi(-38), "square");
        super::near(
            shape.inertia_per_mass(),
            size * size * 2.0 / 3.0,
            2.0_f64.powi(-38),
            "square",
        );
    }
    let [low, high] = [I16F16::MIN, I16F16::MAX];
    let box_of_all =
        [(low, low), (high, low), (high, high), (low, high)].map(|(x, y)| Vec2::new(x, y));
    let side = 65_536.0 - 2.0_f64.powi(-16);
    let all = convex_polygon(&box_of_all).unwrap();
    super::near(all.area(), side * side, super::ROUNDED, "all");
    super::near(
        all.inertia_per_mass(),
        side * side / 6.0,
        super::ROUNDED,
        "all",
    );
}
