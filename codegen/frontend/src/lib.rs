//! Lowers the tree from the DSL to the typed IR, or reports errors at the author's lines.
//!
//! [`typify`] is the lowering. [`diagnostic`] formats the errors, with lines from [`source`]. [`termination`] proves
//! that a loop ends. [`fuse`] substitutes temporaries that evaluation order does not need. `takers` names those that stay. `axes` checks the axes of tables.
//!
//! Must not know: the passes over the IR, and C.

// The order of a hash table differs from run to run: the C must not depend on it.
#![warn(clippy::iter_over_hash_type)]

mod axes;
pub mod diagnostic;
pub mod fuse;
mod numbered_names;
pub mod source;
mod standard;
mod takers;
mod termination;
pub mod typify;
