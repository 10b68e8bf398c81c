//! What a scene stores, in bytes.

use std::mem::size_of;

use fixstep::fixed::types::{I8F24, I12F20, I16F16, I20F12, I32F32};
use fixstep::{
    AllBodies, BodyId, Carried, ConstantAcceleration, DyadicStep, Euler, PerBody, Point, Rigid,
    Scalar, SemiImplicitEuler, Time, Vec2, Verlet, World,
};

fn world_fits<S: Scalar, const N: usize>() {
    let allowed = N * (20 + 4) + 32;
    let size = size_of::<World<Point<S>, N>>();
    assert!(
        size <= allowed,
        "{N} bodies take {size} bytes, {allowed} were promised"
    );
}

fn every_capacity_fits<S: Scalar>() {
    world_fits::<S, 0>();
    world_fits::<S, 1>();
    world_fits::<S, 2>();
    world_fits::<S, 7>();
    world_fits::<S, 64>();
    world_fits::<S, 255>();
    world_fits::<S, 256>();
    world_fits::<S, 1000>();
    world_fits::<S, 65_535>();
}

#[test]
fn a_point_takes_20_bytes_in_any_32_bit_scalar() {
    assert_eq!(size_of::<Point<f32>>(), 20);
    assert_eq!(size_of::<Point<I8F24>>(), 20);
    assert_eq!(size_of::<Point<I12F20>>(), 20);
    assert_eq!(size_of::<Point<I16F16>>(), 20);
    assert_eq!(size_of::<Point<I20F12>>(), 20);
}

#[test]
fn a_point_takes_40_bytes_in_a_64_bit_scalar() {
    assert_eq!(size_of::<Point<f64>>(), 40);
    assert_eq!(size_of::<Point<I32F32>>(), 40);
}

#[test]
fn a_body_that_carries_takes_32_bytes_in_any_32_bit_scalar() {
    assert_eq!(size_of::<Carried<f32>>(), 32);
    assert_eq!(size_of::<Carried<I8F24>>(), 32);
    assert_eq!(size_of::<Carried<I12F20>>(), 32);
    assert_eq!(size_of::<Carried<I16F16>>(), 32);
    assert_eq!(size_of::<Carried<I20F12>>(), 32);
    assert_eq!(size_of::<Carried<f64>>(), 64);
}

#[test]
fn a_body_that_turns_takes_36_bytes_in_32_bit_fixed_point() {
    assert_eq!(size_of::<Rigid<Point<I16F16>>>(), 36);
    assert_eq!(size_of::<Rigid<Point<I8F24>>>(), 36);
    assert_eq!(size_of::<Rigid<Point<f32>>>(), 32);
    assert_eq!(size_of::<Rigid<Carried<I16F16>>>(), 56);
    assert_eq!(size_of::<Rigid<Carried<f32>>>(), 56);
}

#[test]
fn an_id_takes_4_bytes() {
    assert!(size_of::<BodyId>() <= 4);
}

#[test]
fn a_world_adds_an_id_a_body_and_little_else() {
    every_capacity_fits::<f32>();
    every_capacity_fits::<I16F16>();
    every_capacity_fits::<I8F24>();
}

/// The README's figures: 20 bytes a point, 4 its id, 24 the world.
#[test]
fn a_world_of_32_points_takes_792_bytes() {
    assert_eq!(size_of::<World<Point<I16F16>, 32>>(), 32 * (20 + 4) + 24);
}

#[test]
fn methods_of_one_pass_store_nothing() {
    assert_eq!(size_of::<SemiImplicitEuler>(), 0);
    assert_eq!(size_of::<Verlet>(), 0);
}

// The copy of the bodies, and its length: one word.
#[test]
fn methods_that_look_back_carry_their_own_copy() {
    let copy = 20 * 64;
    for size in [
        size_of::<Euler<Point<I16F16>, 64>>(),
        size_of::<ConstantAcceleration<Point<I16F16>, 64>>(),
    ] {
        assert!((copy..=copy + 8).contains(&size), "{size}");
    }
}

type Function = fn(Time, &[Point<f32>], usize) -> Vec2<f32>;

#[test]
fn all_bodies_takes_8_bytes_a_body() {
    assert_eq!(size_of::<AllBodies<(), f32, 16>>(), 8 * 16);
    assert_eq!(size_of::<AllBodies<(), I16F16, 1000>>(), 8 * 1000);
    assert_eq!(
        size_of::<AllBodies<Function, f32, 16>>(),
        8 * 16 + size_of::<usize>()
    );
    assert_eq!(size_of::<PerBody<()>>(), 0);
}

#[test]
fn a_dyadic_step_stores_one_coefficient() {
    assert_eq!(size_of::<DyadicStep<I16F16, 1, 6>>(), 8);
    assert_eq!(size_of::<DyadicStep<f32, 4389, 18>>(), 4);
}
