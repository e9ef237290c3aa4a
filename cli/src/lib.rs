//! `cargo bessemer`: the command that a user of Bessemer installs.
//!
//! Invariants:
//! - it works from any folder of the user's workspace, and changes nothing there but what it says;
//! - a failure is one [`error::Error`], with what to do about it where that is known.
//!
//! It must not know how C is made, nor how a workspace is found (`bessemer-project`).

pub mod args;
pub mod doctor;
pub mod error;
pub mod explain;
pub mod new;
pub mod sizes;
pub mod verify;
