//! What everything costs: steps, forces, flash and RAM.
//!
//! [guide]: super
#![doc = include_str!("../../docs/costs.md")]
