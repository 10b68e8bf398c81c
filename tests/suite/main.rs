//! The quick suite: one binary, so that what tests share is compiled once. `tests/README.md` says which law is where.

mod support;

mod accumulator;
mod between;
mod bounds;
mod capacity;
mod carry;
mod exact_drag;
mod exact_spring;
mod examples;
mod fall;
mod firmware;
mod footprint;
mod forces;
mod high_order;
mod impulse;
mod invariants;
mod laws;
mod layers;
mod limits;
mod mass;
mod momentum;
mod nbody;
mod order;
mod oscillator;
mod own_scalar;
mod range;
mod refusals;
mod rewind;
mod rotor;
mod shape;
mod snapshot;
mod spin;
mod stages;
mod symmetry;
mod time;
