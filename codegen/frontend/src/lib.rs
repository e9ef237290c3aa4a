//! From the tree that the DSL hands on to the typed IR, or to what is told at the author's own line.
//!
//! [`typify`] is the way. [`diagnostic`] is how it tells, with the lines of [`source`]; [`termination`] is its proof that a loop
//! ends. [`fuse`] decides which operands have to be computed before what comes after them.
//!
//! Must not know: what the passes do with the IR, and C.

// The order of a hash table differs from run to run: the C must not depend on it.
#![warn(clippy::iter_over_hash_type)]

pub mod diagnostic;
pub mod fuse;
pub mod source;
mod termination;
pub mod typify;
