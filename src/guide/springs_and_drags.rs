//! Which force, which spring, which drag, and their limits.
//!
//! [rotation-torques]: super::rotation#torques
//! [costs-force]: super::costs#what-a-force-costs
//! [accuracy-stability]: super::accuracy#stability
#![doc = include_str!("../../docs/springs-and-drags.md")]
