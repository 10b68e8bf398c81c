//! How to use the crate from a firmware or a game.
//!
//! [drags-which]: super::springs_and_drags#which-force
//! [errors-do]: super::errors#what-to-do-with-an-error
//! [saving-save]: super::saving#save-and-load
#![doc = include_str!("../../docs/firmware.md")]
