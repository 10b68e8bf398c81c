//! Drags and springs that are solved exactly, at any step.
//!
//! The others of this folder stand on `oscillation`, the exact step of a spring in integers, and on `propagator`,
//! the same step in coefficients of a scalar.

mod ballistic;
mod drag;
mod oscillation;
mod pair;
mod propagator;
mod quadratic_drag;
mod spring;

pub use ballistic::Ballistic;
pub use drag::ExactDrag;
pub use pair::ExactPair;
pub use quadratic_drag::ExactQuadraticDrag;
pub use spring::ExactSpring;
