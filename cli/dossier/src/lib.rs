//! The dossier of a package for the reviewer of its C, as data and as pages.
//!
//! | module | purpose |
//! |---|---|
//! | [`scan`] | functions, statements and decisions of a C file |
//! | [`trace`] | counterparts of lines of C and of Rust |
//! | [`calls`], [`graph`] | calls between the functions of the C, and pictures of them |
//! | [`requirements`] | requirements, and what belongs to each |
//! | [`coverage`] | instrumented C, and the measures of its runs |
//! | [`change`] | parts of the C that changed between two versions |
//! | [`evidence`] | crates, deviations from MISRA C, notes, questions |
//! | [`content`], [`page`] | everything that the pages show, and the pages |
//! | [`manifest`], [`output`] | hashes, and the folder |
//!
//! Invariant: the same sources give the same bytes; no date, no path of a machine. Must not know: the terminal, or how
//! a build of the models is run.

pub mod calls;
pub mod change;
pub mod content;
pub mod coverage;
pub mod evidence;
pub mod graph;
pub mod manifest;
pub mod memory;
pub mod output;
pub mod page;
pub mod requirements;
pub mod scan;
mod separated;
pub mod trace;
