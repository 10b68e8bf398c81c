//! Long sweeps: laws that show only after thousands of steps, or over whole maps.

use fixstep_lab::support;

mod angular_momentum;
mod carry;
mod drawn;
mod kepler;
mod long_run;
mod rounding;
mod stability;

// Of the quick suite: here optimised, with all their steps and number types.
#[path = "../../../tests/suite/accumulator.rs"]
mod accumulator;
#[path = "../../../tests/suite/capacity.rs"]
mod capacity;
#[path = "../../../tests/suite/exact_drag.rs"]
mod exact_drag;
#[path = "../../../tests/suite/exact_spring.rs"]
mod exact_spring;
#[path = "../../../tests/suite/firmware.rs"]
mod firmware;
#[path = "../../../tests/suite/high_order.rs"]
mod high_order;
#[path = "../../../tests/suite/impulse.rs"]
mod impulse;
#[path = "../../../tests/suite/invariants.rs"]
mod invariants;
#[path = "../../../tests/suite/laws.rs"]
mod laws;
#[path = "../../../tests/suite/momentum.rs"]
mod momentum;
#[path = "../../../tests/suite/nbody.rs"]
mod nbody;
#[path = "../../../tests/suite/oscillator.rs"]
mod oscillator;
#[path = "../../../tests/suite/rewind.rs"]
mod rewind;
#[path = "../../../tests/suite/snapshot.rs"]
mod snapshot;
#[path = "../../../tests/suite/spin.rs"]
mod spin;
#[path = "../../../tests/suite/stages.rs"]
mod stages;
#[path = "../../../tests/suite/symmetry.rs"]
mod symmetry;
