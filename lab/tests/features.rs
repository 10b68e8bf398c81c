//! What the crate offers to serde, mint and defmt, each behind the feature of its name.

use fixstep_lab::support;

#[allow(dead_code)]
#[path = "../../tests/suite/snapshot/bytes.rs"]
mod bytes;
#[allow(dead_code)]
#[path = "../../tests/suite/snapshot/samples.rs"]
mod samples;

#[path = "features/carried.rs"]
mod carried;
#[path = "features/log.rs"]
mod log;
#[path = "features/refused.rs"]
mod refused;
#[path = "features/rigid.rs"]
mod rigid;
#[path = "features/round_trips.rs"]
mod round_trips;
#[path = "features/vectors.rs"]
mod vectors;
