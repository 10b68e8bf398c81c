//! Drags and springs that are solved exactly, at any step.
//!
//! The springs use two private modules. `oscillation` is the exact step of a spring in integers. `propagator` is
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
