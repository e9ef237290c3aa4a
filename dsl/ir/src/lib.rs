//! The two forms that a model passes through between Rust and C.
//!
//! * [`tree`]: what the attribute macros hand on. The author's syntax, untyped; beside it the types
//!   that rustc gave to each witness slot.
//! * [`ir`]: typed, names resolved, places explicit, control flow as statements. The interpreter and
//!   the C back end read nothing else. [`text`] prints it and parses it back.
//!
//! Invariants: `no_std`; no nalgebra; nothing here knows Rust's front end or C.

#![no_std]

extern crate alloc;

pub mod attributes;
mod build;
mod canonical;
mod data;
mod enums;
pub mod ir;
pub mod kernel;
pub mod number;
pub mod operation;
pub mod text;
pub mod tree;
pub mod visit;
pub mod words;

pub use attributes::{Attributes, Given, Inlining, Range};
pub use ir::*;
pub use kernel::{Kernel, KernelRoutine};
pub use number::{Float, Int, Scalar};
