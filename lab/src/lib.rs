//! Charts, the adviser and the long sweeps of fixstep: what takes longer than a newcomer waits for `cargo test`.
//!
//! `examples/` makes the charts and answers which number type a scene takes; `tests/` holds long runs, whole maps and the
//! committed charts to their laws. Run it optimised: `cargo test --release -p fixstep-lab`.

#[path = "../../tests/suite/support/mod.rs"]
pub mod support;
