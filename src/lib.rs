//! Moves 2D bodies under forces at a fixed timestep: no heap, no panic, no hidden cost, in `f32` or
//! in fixed point from one source.
//!
//! ```text
//! scene -> forces -> kick (v) -> drift (x) -> read-out          once per step
//! ```
//!
//! * [`World`] holds the bodies; [`Point`] is the compact one, 20 bytes in any 32-bit scalar.
//! * A [`Rigid`] body is a point that turns, with an [`Angle`] that wraps exactly.
//! * A [`Force`](force) says what it does to a body; a tuple of forces is a force.
//! * A [method](integrate) says when. [`Verlet`] is the one to start with.
//! * [`guide`]: which method, which number type, which rate.
//! * [`Step`] or [`DyadicStep`] is the timestep. Time is a count of ticks.
//! * An [`Accumulator`] says how many steps a frame is due, [`Between`] where to draw in between.
//! * [`rewind`] undoes steps to the bit, in fixed point, for a world of [`RangeChecked`] bodies.
//! * [`snapshot`] saves a world as bytes; [`error`] has a table of what is refused.
//! * [`Scalar`](scalar) is the law that every number type keeps: total, odd, nearest, same bits.
//!
//! Units are SI as far as the crate is concerned (m, s, kg); a scene may read them as pixels and
//! frames. The axes are the scene's too; the examples have x to the right and y up.
//!
//! | rung | what a scene adds | where |
//! |---|---|---|
//! | 1 | points with mass, forces, a method | root files, [`force`], [`integrate`] |
//! | 2 | bodies that turn, torques | [`rigid`], [`torque`] |
//!
//! Optional features, none on by default: `serde`, `defmt` (its `Format`), `mint` (vectors).
//!
//! Contacts and joints are further rungs, not built yet. A scene pays flash, memory and instructions
//! only for what it names: one of points alone holds nothing of rung two.
//!
//! It starts from Chris Hecker's "Physics, The Next Frontier" (Game Developer, 1996), whose
//! equations its methods and forces name.
#![no_std]
#![forbid(unsafe_code)]
#![deny(missing_docs)]

pub mod error;
pub mod ratio;
pub mod scalar;
pub mod vec2;

pub mod body;
pub mod force;
pub mod integrate;
pub mod mass;
pub mod time;
pub mod world;

pub mod rigid;

pub mod guide;
mod interop;
pub mod prelude;

pub use fixed;
pub use heapless;

pub use body::{Body, BodyId, Carried, Point, RangeChecked, Reverse, Stale};
pub use error::{Error, Full};
pub use force::{
    AllBodies, AllPairs, Anchor, Ballistic, ExactDrag, ExactPair, ExactQuadraticDrag, ExactSpring,
    Force, Frame, Gravity, GravityY, LinearDrag, PairForce, Pairs, Part, PerBody, PositionOnly,
    Pull, Push, QuadraticDrag, Reversible, ReversiblePair, Spring, Window,
};
pub use integrate::{
    ConstantAcceleration, Euler, Method, Pefrl, Rewinds, Rk4, SemiImplicitEuler, Verlet,
};
pub use mass::{CentreOfMass, MassProperties, PointMass, Shape};
pub use ratio::Ratio;
pub use rigid::{Angle, Kind, Rigid, Rotating, Rotation};
pub use scalar::{Angular, Carry, CarryAngular, Decay, Exact, Factor, Rational, Scalar, Stored};
pub use time::{Accumulator, Between, Due, DyadicStep, Now, Step, Time, TimeStep};
pub use vec2::{Vec2, vec2};
pub use world::World;
pub use world::rewind::RewindError;
pub use world::snapshot::{Saved, SnapshotError};

/// The scene of the README is a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
