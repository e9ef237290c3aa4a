//! Programs in plain Rust with nalgebra. Each was written from its task alone by an author who had never seen the DSL,
//! and attributes and imports were added.
//!
//! `programs/` has them as they came, `marks/` what stands beside them, and README.md those that do not become C yet.

#![no_std]
#![allow(missing_docs, clippy::all, warnings)]

pub use callables::Entry;

/// The programs, with their marks.
pub mod programs {
    include!(concat!(env!("OUT_DIR"), "/programs.rs"));
}
