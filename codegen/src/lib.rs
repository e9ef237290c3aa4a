//! Compiles the tree of a package of models to C99.
//!
//! [`compile`] runs all stages: `bessemer-frontend` types the tree; `bessemer-backend` proves and prints.
//! [`generate`] is the work of the command line around it.

pub mod compile;
pub mod deep;
pub mod derivatives;
pub mod estimate;
pub mod generate;
pub mod remarks;
