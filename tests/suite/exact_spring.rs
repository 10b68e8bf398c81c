//! Springs solved exactly: `ExactSpring` and `ExactPair` against the exact flow in twice the
//! precision of `f64`, over every scalar and both splitting methods.

#[path = "exact_spring/drag.rs"]
mod drag;
#[path = "exact_spring/flow.rs"]
mod flow;
#[path = "exact_spring/hanging.rs"]
mod hanging;
#[path = "exact_spring/long.rs"]
mod long;
#[path = "exact_spring/matrix.rs"]
mod matrix;
#[path = "exact_spring/motion.rs"]
mod motion;
#[path = "exact_spring/pair.rs"]
mod pair;
#[path = "exact_spring/rounding.rs"]
mod rounding;
#[path = "exact_spring/rules.rs"]
mod rules;
#[path = "exact_spring/sag.rs"]
mod sag;
#[path = "exact_spring/splitting.rs"]
mod splitting;
#[path = "exact_spring/window.rs"]
mod window;
