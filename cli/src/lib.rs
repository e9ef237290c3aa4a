//! `cargo bessemer`: the command that a user of Bessemer installs.
//!
//! Invariants:
//! - it works from any folder of the user's workspace, and changes nothing there but what it says;
//! - a failure is one [`error::Error`], with what to do about it where that is known.
//!
//! [`same_bits`] is `verify` as a test calls it.
//!
//! It must not know how C is made, nor how a workspace is found (`bessemer-project`).

pub mod args;
pub mod asap2;
pub mod campaign;
pub mod counterpart;
pub mod doctor;
pub mod dossier;
pub mod error;
pub mod explain;
pub mod fmu;
pub mod new;
pub mod pack;
pub mod python;
mod same_bits;
pub mod sizes;
mod task;
pub mod vectors;
pub mod verify;

pub use same_bits::{same_bits, same_bits_at};
pub use task::perform;
