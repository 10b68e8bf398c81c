//! Snapshots: what was saved goes on with the same bits, and nothing else is read.

#[path = "snapshot/bodies.rs"]
mod bodies;
#[path = "snapshot/bytes.rs"]
mod bytes;
#[path = "snapshot/carried.rs"]
mod carried;
#[path = "snapshot/cast.rs"]
mod cast;
#[path = "snapshot/cuts.rs"]
mod cuts;
#[path = "snapshot/damage.rs"]
mod damage;
#[path = "snapshot/elsewhere.rs"]
mod elsewhere;
#[path = "snapshot/fuzz.rs"]
mod fuzz;
#[path = "snapshot/layout.rs"]
mod layout;
#[path = "snapshot/refusals.rs"]
mod refusals;
#[path = "snapshot/rigid.rs"]
mod rigid;
#[path = "snapshot/rigid_states.rs"]
mod rigid_states;
#[path = "snapshot/samples.rs"]
mod samples;
#[path = "snapshot/scenes.rs"]
mod scenes;
#[path = "snapshot/states.rs"]
mod states;
#[path = "snapshot/tally.rs"]
mod tally;
#[path = "snapshot/turning.rs"]
mod turning;
