//! How wrong a scene is: long runs, stability, and error against cost.
#![doc = include_str!("../../docs/accuracy.md")]
