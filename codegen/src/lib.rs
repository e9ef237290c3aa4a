//! From the tree of a package of models to C99.
//!
//! [`compile`] is the whole way, stage by stage: bessemer-frontend types the tree, bessemer-backend proves and prints.
//! [`generate`] is the command line's work around it.

pub mod compile;
pub mod deep;
pub mod generate;
pub mod remarks;
