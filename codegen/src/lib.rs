//! From the tree of a package of models to C99.
//!
//! [`compile`] is the whole way, stage by stage; [`generate`] is the command line's work around it.
//! Each stage takes the form before it and gives the form behind it; none imports another, save that the C asks the proofs
//! of the passes which sizes fit into 32 bits (`passes::sizes`). What all of them ask of the IR is in [`effects`],
//! [`alias`] and [`built`].

mod alias;
mod built;
pub mod c;
pub mod compile;
pub mod deep;
pub mod diagnostic;
mod effects;
pub mod generate;
pub mod kernels;
pub mod passes;
pub mod remarks;
pub mod source;
mod termination;
pub mod typify;
mod uncopied;
pub mod used;
pub mod validate;
