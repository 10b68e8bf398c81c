//! Errors and costs of other engines, and what they do more.
#![doc = include_str!("../../docs/comparison.md")]
