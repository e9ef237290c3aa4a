//! Typed form between the author's tree and C.
//!
//! * [`ir`]: typed, names resolved, places explicit, control flow as statements. The interpreter and the C back end
//!   read nothing else. [`text`] prints and parses it.
//! * [`effects`] and [`alias`] compute for all stages which places are read, written and overlapping; [`used`] counts
//!   the uses of proof rules.
//! * [`tree`]: the form before it, from the DSL, re-exported for crates that use both.
//!
//! Invariants: `no_std`; no nalgebra; nothing here depends on Rust's front end or C.

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
pub mod tables;
pub mod text;
pub mod used;
pub mod visit;
pub mod words;
mod written;

pub use bessemer_tree as tree;
pub use bessemer_tree::attributes::{self, Attributes, Given, Inlining, Range};
pub use bessemer_tree::number::{self, Float, Int, Scalar};
pub use bessemer_tree::operation;
pub use ir::*;
pub use kernel::{Kernel, KernelRoutine};
pub use written::Written;
