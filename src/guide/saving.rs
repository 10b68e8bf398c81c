//! How to save a world, load it, and go back.
//!
//! [errors-do]: super::errors#what-to-do-with-an-error
#![doc = include_str!("../../docs/saving.md")]
