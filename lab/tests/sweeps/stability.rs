//! Where each method stops being stable, measured against closed forms: for springs by `ω h` and
//! damping ratio, for drag by `k h / m` and `h c |v| / m`.
//!
//! `-- --nocapture` prints the maps.

#[path = "stability/drag.rs"]
mod drag;
#[path = "stability/drag_cell.rs"]
mod drag_cell;
#[path = "stability/drag_map.rs"]
mod drag_map;
#[path = "stability/edge.rs"]
mod edge;
#[path = "stability/exact.rs"]
mod exact;
#[path = "stability/law.rs"]
mod law;
#[path = "stability/map.rs"]
mod map;
#[path = "stability/run.rs"]
mod run;
#[path = "stability/scene.rs"]
mod scene;

use fixstep::fixed::types::{I8F24, I16F16};

#[test]
fn map_of_springs() {
    map::print_map();
}

#[test]
fn runs_of_springs_in_floats() {
    map::check_map::<f64>();
    map::check_map::<f32>();
}

#[test]
fn runs_of_springs_in_i16f16() {
    map::check_map::<I16F16>();
}

#[test]
fn runs_of_springs_in_i8f24() {
    map::check_map::<I8F24>();
}

#[test]
fn bounded_below_each_limit_and_growing_above_in_f64() {
    edge::check::<f64>();
}

#[test]
fn bounded_below_each_limit_and_growing_above_in_f32() {
    edge::check::<f32>();
}

#[test]
fn bounded_below_each_limit_and_growing_above_in_i8f24() {
    edge::check::<I8F24>();
}

#[test]
fn drag_alone_in_floats() {
    drag_map::check::<f64>();
    drag_map::check::<f32>();
}

#[test]
fn drag_alone_in_fixed_point() {
    drag_map::check::<I16F16>();
    drag_map::check::<I8F24>();
}

#[test]
fn limits_of_drag_alone() {
    drag_map::check_limits();
}
