//! Which number type fits a scene, and what tells you.
#![doc = include_str!("../../docs/adviser.md")]
