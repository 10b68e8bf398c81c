//! What the crate offers to serde, mint and defmt, each behind the feature of its name. Without
//! features there is nothing here to test:
//!
//! ```text
//! cargo test --features "serde mint defmt"
//! ```

#[cfg(feature = "serde")]
#[path = "suite/support/mod.rs"]
mod support;

#[cfg(feature = "serde")]
#[allow(dead_code)]
#[path = "suite/snapshot/bytes.rs"]
mod bytes;
#[cfg(feature = "serde")]
#[allow(dead_code)]
#[path = "suite/snapshot/samples.rs"]
mod samples;

#[cfg(feature = "serde")]
#[path = "features/carried.rs"]
mod carried;
#[cfg(feature = "defmt")]
#[path = "features/log.rs"]
mod log;
#[cfg(feature = "serde")]
#[path = "features/refused.rs"]
mod refused;
#[cfg(feature = "serde")]
#[path = "features/rigid.rs"]
mod rigid;
#[cfg(feature = "serde")]
#[path = "features/round_trips.rs"]
mod round_trips;
#[cfg(feature = "mint")]
#[path = "features/vectors.rs"]
mod vectors;
