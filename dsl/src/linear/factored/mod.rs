//! Decompositions as values, written in the DSL for the C. nalgebra's `lu`, `cholesky`, `qr` and `udu` have
//! nalgebra's order of operations; eigenvalues and singular values have their own.
//!
//! Such a value is nalgebra's type in the simulation, and a struct of these modules in the C. Both have the same
//! methods, and models hold them in locals.
//!
//! A computed index is limited by `min`, which changes no value and makes its check provable. So an infallible entry
//! point may factor matrices.

pub mod cholesky;
pub mod eigen;
pub mod ldl;
pub mod lu;
pub mod qr;
pub mod svd;
pub mod triangular;
pub mod udu;
