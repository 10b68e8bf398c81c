//! Bodies that keep what their roundings leave over: what a push exchanges, and the laws that a point keeps. What they lose in a
//! million steps, the lab measures.

#[path = "carry/bits.rs"]
mod bits;
#[path = "carry/exchange.rs"]
mod exchange;
#[path = "carry/fall.rs"]
mod fall;
#[path = "carry/floats.rs"]
mod floats;
#[path = "carry/flows.rs"]
mod flows;
#[path = "carry/momentum.rs"]
mod momentum;
#[path = "carry/range.rs"]
mod range;
#[path = "carry/symmetry.rs"]
mod symmetry;
#[path = "carry/verbs.rs"]
mod verbs;
