//! Bodies that keep what their roundings leave over: what they lose in a million steps, what a push
//! exchanges, and the laws that a point keeps.

mod support;

#[path = "carry/bits.rs"]
mod bits;
#[path = "carry/cruise.rs"]
mod cruise;
#[path = "carry/exchange.rs"]
mod exchange;
#[path = "carry/fall.rs"]
mod fall;
#[path = "carry/floats.rs"]
mod floats;
#[path = "carry/momentum.rs"]
mod momentum;
#[path = "carry/range.rs"]
mod range;
#[path = "carry/spring.rs"]
mod spring;
#[path = "carry/symmetry.rs"]
mod symmetry;
#[path = "carry/verbs.rs"]
mod verbs;
