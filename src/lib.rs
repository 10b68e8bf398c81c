//! 2D bodies under forces at a fixed timestep: no heap, no panic, in `f32` or in fixed point from one source.
//!
//! ```
//! use fixstep::fixed::types::I16F16;
//! use fixstep::prelude::*;
//!
//! let mut world = World::<Point<I16F16>, 8>::new();
//! let ball = world.add(Point::new(vec2(0, 2)?, vec2(12, 9)?, dec!(0.45))?)?; // m, m/s, kg
//! let mut forces = (GravityY::new(dec!(-9.81))?, LinearDrag::new(dec!(0.1))?);
//! let step = Step::hz(60)?;
//! for _ in 0..60 {
//!     world.step(&mut Verlet, &mut forces, &step);
//! }
//! assert!(world.get(ball)?.position().x > 10);
//! # Ok::<(), Error>(())
//! ```
//!
//! Replace `I16F16` by `f32` or by another fixed-point type, and nothing else changes.
//!
//! | task | names |
//! |---|---|
//! | start | [`prelude`]: what most scenes name; [`guide`]: which method, which number type, which rate |
//! | make a body | [`Point`], [`Carried`] (keeps what rounding loses), [`vec2()`], [`dec!`], [`CentreOfMass`] |
//! | keep bodies | [`World`]: `add`, `get`, `get_mut`, `remove`, `iter`; [`BodyId`] |
//! | move it | [`World::step`], [`Verlet`], [`SemiImplicitEuler`]; [`integrate`] has all methods |
//! | push it | [`Body::push`] for an impulse; [`Push`], [`GravityY`], [`LinearDrag`], [`PerBody`]; [`force`] has all forces |
//! | tie it | [`Anchor`], [`Spring`] in [`Pairs`], [`ExactSpring`], [`ExactPair`] |
//! | time | [`Step`], [`DyadicStep`]; [`Accumulator`]: the steps due in a frame |
//! | draw | [`Between`] and [`World::between`]: positions between two steps |
//! | rotate | [`Rigid`], [`Rotating`], [`Angle`], [`rigid::torque`], [`mass`] |
//! | save | [`World::save`], [`World::load`], [`world::snapshot`]; a clone within one program |
//! | go back | [`World::step_back`], [`RangeChecked`], [`world::rewind`] |
//! | measure | [`World::momentum`], [`World::kinetic_energy`], [`World::state_hash`], [`World::out_of_range`] |
//! | number types | `f32`, `f64`, [`fixed`]'s signed types; [`scalar`] has the laws; [`Ratio`] for numbers known at run time |
//! | errors | [`Error`]; [`error`] has a table of what is refused |
//!
//! Units are metres, seconds and kilograms by name; pixels and frames work as well. The axes are yours. In the
//! examples x points to the right and y up.
//!
//! # How a step works
//!
//! ```text
//! scene -> forces -> kick (v) -> drift (x) -> read-out          once per step
//! ```
//!
//! A [`World`] holds bodies. A force says what it does to a body; a tuple of forces is a force. A method says
//! when: it orders *kicks*, which change velocities, and *drifts*, which change positions. Time is a count of steps.
//!
//! # What a scene pays for
//!
//! A scene pays flash, memory and instructions only for what it names. A scene of points alone contains nothing of
//! [`rigid`]. Contacts and joints do not exist yet.
//!
//! Optional features, none on by default: `serde`, `defmt` (its `Format`), `mint` (vectors).
//!
//! The crate starts from Chris Hecker's "Physics, The Next Frontier" (Game Developer, 1996), whose equations its
//! methods and forces name.
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
