//! Linear algebra: what nalgebra's methods become in the C, and what nalgebra leaves open.
//!
//! Systems of equations and inverses: nalgebra's own decompositions of fixed matrices end at 127 rows. These
//! have no end, the operation order of nalgebra's, and therefore its bits. They work in place: pass large
//! matrices behind `&mut`.
//!
//! Every other module has functions of the DSL that say what nalgebra's methods compute, in its order; only
//! the C comes from them, save for eigenvalues, singular values and exponentials, which are the DSL's own.
//!
//! Absent: allocation.

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
