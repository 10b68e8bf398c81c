//! How bodies rotate: angles, torques, shapes.
//!
//! [costs-turning]: super::costs#bodies-that-turn
#![doc = include_str!("../../docs/rotation.md")]
