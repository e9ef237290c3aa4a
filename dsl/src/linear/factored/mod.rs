//! Decompositions as values: what nalgebra's `lu`, `cholesky`, `qr` and `udu` give, in its order of
//! operations, and eigenvalues and singular values in an order of their own; written in the DSL for the C.
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
