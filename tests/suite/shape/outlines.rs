//! Outlines that are refused: by name, at the right corner, and never with a panic.

use fixstep::fixed::types::{I1F31, I8F24, I16F16, I32F32};
use fixstep::mass::{convex_polygon, polygon};
use fixstep::{Error, Rational, Vec2, vec2};

use super::support::Random;

const FLAT: Error = Error::Degenerate { shape: "polygon" };

fn both<S: Rational>(corners: &[Vec2<S>]) -> Error {
    let (any, convex) = (polygon(corners), convex_polygon(corners));
    assert_eq!(any, convex);
    any.unwrap_err()
}

fn corners<const N: usize, S: Rational>(places: [(i32, i32); N]) -> [Vec2<S>; N] {
    places.map(|(x, y)| vec2(x, y).unwrap())
}

#[test]
fn outlines_without_area() {
    assert_eq!(both::<f32>(&[]), Error::Empty { field: "vertices" });
    assert_eq!(both::<f32>(&corners([(0, 0)])), FLAT);
    assert_eq!(both::<I16F16>(&corners([(0, 0), (1, 1)])), FLAT);
    assert_eq!(both::<I16F16>(&corners([(7, 7); 5])), FLAT);
    assert_eq!(both::<f64>(&corners([(0, 0); 5])), FLAT);
    assert_eq!(
        both::<I8F24>(&corners([(0, 1), (2, 3), (5, 6), (-8, -7)])),
        FLAT
    );
    // A bow: two lobes alike.
    assert_eq!(
        both::<f32>(&corners([(0, 0), (2, 2), (2, 0), (0, 2)])),
        FLAT
    );
    // Less than 2^-62 m².
    let tiny = [(0.0, 0.0), (1e-10, 0.0), (0.0, 1e-10)].map(|(x, y)| Vec2::new(x, y));
    assert_eq!(both::<f64>(&tiny), FLAT);
    let least = f64::from_bits(1);
    assert_eq!(
        both(&[Vec2::ZERO, Vec2::new(least, 0.0), Vec2::new(0.0, least)]),
        FLAT
    );
}

#[test]
fn lobes_whose_inertia_is_below_zero() {
    // A square of 4 m² and, 100 m off, one of 1 m² the other way round.
    let far = [
        (0, 0),
        (2, 0),
        (2, 2),
        (0, 2),
        (0, 0),
        (99, 0),
        (99, 1),
        (100, 1),
        (100, 0),
        (0, 0),
    ];
    assert_eq!(polygon(&corners::<10, f32>(far)).unwrap_err(), FLAT);
}

fn both_or_none<S: Rational>(corners: &[Vec2<S>]) -> bool {
    polygon(corners).is_ok() | convex_polygon(corners).is_ok()
}

#[test]
fn numbers_that_are_none() {
    let refused = Error::NotFinite { field: "vertices" };
    for bad in [
        f32::NAN,
        f32::INFINITY,
        f32::NEG_INFINITY,
        f32::MAX,
        f32::MIN,
        1e10,
    ] {
        let sound = corners::<3, f32>([(0, 0), (1, 0), (0, 1)]);
        for i in 0..3 {
            let mut tried = sound;
            tried[i].x = bad;
            assert_eq!(polygon(&tried).unwrap_err(), refused, "{bad}");
            tried = sound.map(|v| v.map(|s| s * bad));
            assert_eq!(both(&tried), refused, "{bad}");
        }
    }
    for bad in [f64::NAN, f64::INFINITY, f64::MAX, -1e200] {
        assert_eq!(
            both(&[Vec2::ZERO, Vec2::new(bad, 0.0), Vec2::new(bad, bad)]),
            refused
        );
    }
    let all = [I32F32::MIN, I32F32::MAX];
    let triangle = [
        Vec2::new(all[0], all[0]),
        Vec2::new(all[1], all[0]),
        Vec2::new(all[0], all[1]),
    ];
    assert_eq!(both(&triangle), refused);
    let [low, high] = [I1F31::MIN, I1F31::MAX];
    assert!(
        convex_polygon(&[
            Vec2::new(low, low),
            Vec2::new(high, low),
            Vec2::new(low, high)
        ])
        .is_ok()
    );
}

// Any outline at all: of the ends of the range, of numbers from one end of the exponents to the other,
// and crossing itself.
#[test]
fn nothing_panics() {
    let mut random = Random(3);
    for round in 0..20_000 {
        let n = round % 9;
        let mut number = || match random.next() % 4 {
            0 => I16F16::MIN,
            1 => I16F16::MAX,
            _ => I16F16::from_bits(random.next() as i32),
        };
        let fixed: Vec<_> = (0..n).map(|_| Vec2::new(number(), number())).collect();
        let mut number = || match random.next() % 4 {
            0 => f64::from_bits(random.next()),
            1 => 0.0,
            _ => f64::from_bits(random.next() % (1 << 62) / 16 * 15 + (1 << 58)),
        };
        let float: Vec<_> = (0..n).map(|_| Vec2::new(number(), number())).collect();
        both_or_none(&fixed);
        both_or_none(&float);
    }
}

// Each turn adds as much to the sums, of which one turn of the largest square takes all there is.
#[test]
fn outlines_that_wind_often() {
    let edge = 1.0 - f64::EPSILON / 2.0;
    let places = [(-1.0, -1.0), (edge, -1.0), (-1.0, edge)];
    for turns in 1..200 {
        let corners = places.map(|(x, y)| Vec2::new(x, y)).repeat(turns);
        let _ = polygon(&corners);
        assert_eq!(convex_polygon(&corners).is_ok(), turns == 1);
    }
}

#[test]
fn corners_that_are_not_convex() {
    let bad = |vertex| Err(Error::NotConvex { vertex });
    let of = |places: &[(i32, i32)]| {
        let corners: Vec<Vec2<I16F16>> = places.iter().map(|&(x, y)| vec2(x, y).unwrap()).collect();
        let mut backwards = corners.clone();
        backwards.reverse();
        let told = convex_polygon(&corners).map(|_| ());
        assert_eq!(told.is_ok(), convex_polygon(&backwards).is_ok());
        told
    };
    assert_eq!(of(&[(0, 0), (4, 0), (4, 4), (0, 4)]), Ok(()));
    assert_eq!(
        of(&[(4, 0), (2, 3), (-2, 3), (-4, 0), (-2, -3), (2, -3)]),
        Ok(())
    );
    // A dent, a straight corner, one that is there twice, a spike, a pentagram.
    assert_eq!(of(&[(0, 0), (4, 0), (1, 1), (0, 4)]), bad(2));
    assert_eq!(of(&[(1, 1), (0, 4), (0, 0), (4, 0)]), bad(0));
    assert_eq!(of(&[(0, 0), (4, 0), (4, 2), (4, 4), (0, 4)]), bad(2));
    assert_eq!(of(&[(0, 0), (4, 0), (4, 0), (4, 4), (0, 4)]), bad(1));
    assert_eq!(
        of(&[(0, 0), (4, 0), (9, 0), (4, 0), (4, 4), (0, 4)]),
        bad(1)
    );
    assert_eq!(of(&[(0, 10), (-6, -8), (10, 3), (-10, 3), (6, -8)]), bad(4));
}
