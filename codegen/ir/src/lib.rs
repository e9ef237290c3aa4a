//! The typed form between the author's tree and C.
//!
//! * [`ir`]: typed, names resolved, places explicit, control flow as statements. The interpreter and
//!   the C back end read nothing else. [`text`] prints it and parses it back.
//! * [`effects`] and [`alias`]: what stages ask of it, what is read and written, and which places may be one; [`used`]
//!   counts how often they prove by it.
//! * [`tree`]: the form before it, which the DSL hands on, for whoever reads both.
//!
//! Invariants: `no_std`; no nalgebra; nothing here knows Rust's front end or C.

#![no_std]

extern crate alloc;

pub mod alias;
mod build;
mod canonical;
mod data;
pub mod effects;
mod enums;
pub mod ir;
pub mod kernel;
mod operator;
pub mod text;
pub mod used;
pub mod visit;
pub mod words;

pub use bessemer_tree as tree;
pub use bessemer_tree::attributes::{self, Attributes, Given, Inlining, Range};
pub use bessemer_tree::number::{self, Float, Int, Scalar};
pub use bessemer_tree::operation;
pub use ir::*;
pub use kernel::{Kernel, KernelRoutine};
