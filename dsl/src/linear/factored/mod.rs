//! Decompositions as values, written in the DSL for the C. nalgebra's `lu`, `cholesky`, `qr` and `udu` have its order
//! of operations; eigenvalues and singular values have an order of their own.
//!
//! In the simulation such a value is nalgebra's own; in the C it is a struct of these modules. Both go by
//! the same methods, and a model holds them in locals.
//!
//! An index that is computed is kept within its bounds by `min`, which changes nothing and leaves no check:
//! so an infallible entry point may factor matrices.

pub mod cholesky;
pub mod eigen;
pub mod ldl;
pub mod lu;
pub mod qr;
pub mod svd;
pub mod triangular;
pub mod udu;
