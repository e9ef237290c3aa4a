//! Linear algebra: nalgebra's methods for the C, and solves and inverses of any size.
//!
//! nalgebra's decompositions of fixed matrices are limited to 127 rows. The functions here have no limit, and
//! nalgebra's order of operations, so the same bits. They work in place: pass large matrices by `&mut`.
//!
//! The other modules have functions of the DSL that compute like nalgebra's methods, in its order; only the C uses
//! them. Eigenvalues, singular values and exponentials are the DSL's own.
//!
//! No function allocates.

pub mod blas;
pub mod each_element;
pub mod elementwise;
pub mod factored;
pub mod kernels;
pub mod lines;
mod literal;
mod lu;
pub mod matrix_edit;
pub mod matrix_extremes;
pub mod matrix_powers;
pub mod matrix_resize;
pub mod matrix_statistics;
pub mod norms;
pub mod parts;
pub mod spatial;
mod systems;
pub mod views;

pub use factored::eigen::symmetric as symmetric_eigen;
pub use factored::ldl::factored as ldl;
pub use factored::svd::jacobi as svd;
pub use literal::by_rows;
pub use lu::{inverse_mut, solve_into, solve_mut};
#[cfg(feature = "generate")]
#[doc(hidden)]
pub use systems::InverseCompanion;
pub use systems::{inverse, solve};
