//! Forces that rotate bodies.
//!
//! | force | acts on | cost |
//! |---|---|---|
//! | [`Torque`] | one body | a product and one more |
//! | [`SpinDrag`] | every body, damped | a product; an exponential where the inertia changes |
//! | [`Attached`] | two bodies, at a point of each | a [`Spring`](crate::Spring), and for each body a sine, a cosine and ten products |
//! | [`Wrench`] | what a function of [`PerBody`](crate::PerBody) may return | two products an axis |
//!
//! The forces of [`force`](crate::force) act on the centre of mass of a rigid body as they do on a point.

mod attached;
mod motor;
mod spin_drag;
mod wrench;

pub use attached::Attached;
pub use motor::Torque;
pub use spin_drag::SpinDrag;
pub use wrench::Wrench;
