//! How to make numbers that are known at run time.
#![doc = include_str!("../../docs/run-time-numbers.md")]
