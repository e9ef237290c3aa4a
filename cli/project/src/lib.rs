//! A user's workspace: found from any folder in it, its `bessemer.toml` read, its C generated.
//!
//! `cargo bessemer` and `cargo xtask` share this crate, so that both do the same and report it alike.
//!
//! Invariants:
//! - a failure is one [`Error`], with a remedy where one is known;
//! - each key of `bessemer.toml` is in one table, [`keys::KEYS`], which reader, schema and documentation follow.
//!
//! It must not know how C is made, nor what else the commands do.

pub mod build_files;
mod error;
pub mod file;
pub mod firmware;
mod generation;
pub mod inputs;
pub mod interface;
pub mod keys;
pub mod outputs;
pub mod parameters;
mod project;
pub mod schema;
mod settings;

pub use error::{Error, say};
pub use generation::{
    Figure, Generated, Said, Wanted, compile, generate, hold, parameter_tables, said,
};
pub use project::Project;
pub use settings::{Limit, Limits, Settings};
