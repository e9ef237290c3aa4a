//! The dossier of a package: what a reviewer of its C asks for, as data and as pages.
//!
//! | module | purpose |
//! |---|---|
//! | [`scan`] | functions, statements and decisions of a C file |
//! | [`trace`] | counterparts of lines of C and of Rust |
//!
//! Invariant: the same sources give the same bytes; no date, no path of a machine. Must not know: the terminal, or how
//! a build of the models is run.

pub mod scan;
pub mod trace;
