//! Vectors to mint's vectors and points, and back, in any scalar and with the axes in their places.

use fixstep::Vec2;
use fixstep::fixed::types::I16F16;
use mint::{IntoMint, Point2, Vector2};

fn there_and_back<S: Copy + PartialEq + std::fmt::Debug>(x: S, y: S) {
    let own = Vec2 { x, y };
    let vector = Vector2::from(own);
    assert_eq!((vector.x, vector.y), (x, y));
    assert_eq!(Vec2::from(vector), own);
    let point = Point2::from(own);
    assert_eq!((point.x, point.y), (x, y));
    assert_eq!(Vec2::from(point), own);
}

#[test]
fn vectors_and_points() {
    there_and_back(1.5_f32, -2.0);
    there_and_back(f64::MAX, f64::MIN_POSITIVE);
    there_and_back(I16F16::MAX, I16F16::MIN);
}

/// What a library that speaks mint asks for.
fn difference(v: impl IntoMint<MintType = Vector2<f32>>) -> f32 {
    let v: Vector2<f32> = v.into();
    v.x - v.y
}

#[test]
fn a_function_that_takes_mint_takes_ours() {
    assert_eq!(difference(Vec2::new(3.0, 1.0)), 2.0);
}
