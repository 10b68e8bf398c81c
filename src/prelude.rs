//! The names that most scenes use: `use fixstep::prelude::*;`.
//!
//! ```
//! use fixstep::fixed::types::I16F16;
//! use fixstep::prelude::*;
//!
//! let mut world = World::<Point<I16F16>, 8>::new();
//! let ball = world.add(Point::new(vec2(0, 2)?, vec2(12, 9)?, dec!(0.45))?)?;
//! world.step(&mut Verlet, &mut GravityY::new(dec!(-9.81))?, &Step::hz(60)?);
//! assert!(world.get(ball)?.position().y > 2);
//! # Ok::<(), Error>(())
//! ```

pub use crate::body::{Body, BodyId, Carried, Point};
pub use crate::dec;
pub use crate::error::Error;
pub use crate::force::{
    Anchor, ExactDrag, ExactSpring, Gravity, GravityY, LinearDrag, Pairs, PerBody, Push, Spring,
};
pub use crate::integrate::{SemiImplicitEuler, Verlet};
pub use crate::rigid::{Angle, Rigid, Rotating};
pub use crate::scalar::Scalar;
pub use crate::time::{Accumulator, Between, DyadicStep, Step};
pub use crate::vec2::{Vec2, vec2};
pub use crate::world::World;
