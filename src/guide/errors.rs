//! What to do with an error.
//!
//! [saving-save]: super::saving#save-and-load
#![doc = include_str!("../../docs/errors.md")]
