//! What an author asks of the C of a function, beside what it does.
//!
//! Invariant: none of it changes what a function computes.

use alloc::string::String;

use serde::{Deserialize, Serialize};

/// What an author asks of the C of a function.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Attributes {
    /// Its name in the C, in place of the one that the tool would choose.
    pub name: Option<String>,
    /// The section of the object file in which it stands.
    pub section: Option<String>,
    /// Whether compilers may put it where it is called.
    pub inlining: Inlining,
    /// An entry point that leaves everything as it was if it faults.
    pub atomic: bool,
    /// The header of a function that the firmware brings; what stands in the Rust stands in for it.
    pub external: Option<String>,
}

/// Whether compilers may put a function where it is called.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Inlining {
    /// As they like.
    #[default]
    Free,
    /// Never: `#[inline(never)]`.
    Never,
    /// Always: `#[inline(always)]`.
    Always,
}
