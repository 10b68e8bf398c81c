//! Moves 2D bodies under forces at a fixed timestep: no heap, no panics, in `f32` or in fixed
//! point from one source.
#![no_std]
#![forbid(unsafe_code)]
#![deny(missing_docs)]

pub mod error;
pub mod ratio;
pub mod scalar;
pub mod vec2;

pub mod body;
pub mod id;
pub mod time;

pub mod force;
pub mod integrate;

pub mod measure;
pub mod world;

pub use fixed;

pub use body::{Body, Point};
pub use error::{Error, Full};
pub use force::{AllBodies, Anchor, Force, Gravity, GravityY, LinearDrag, PerBody, Spring};
pub use id::BodyId;
pub use integrate::{ConstantAcceleration, Euler, Method, SemiImplicitEuler, Verlet};
pub use ratio::Ratio;
pub use scalar::Scalar;
pub use time::{DyadicStep, Step, Time, TimeStep};
pub use vec2::{Vec2, vec2};
pub use world::World;
