//! What the charts are made of, where it is more than a run: the faults that they show.

mod support;

#[path = "charts/wrong.rs"]
mod wrong;
