//! All examples, and their pictures.
//!
//! [rotation-examples]: super::rotation#examples
//! [accuracy-growth]: super::accuracy#growth
#![doc = include_str!("../../docs/examples.md")]
