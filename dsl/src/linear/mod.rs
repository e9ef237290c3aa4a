//! Linear algebra that nalgebra leaves open: systems of equations of any fixed size.
//!
//! nalgebra's own decompositions of fixed matrices end at 127 rows. These have no end, the operation
//! order of nalgebra's, and therefore its bits. They work in place: pass large matrices behind `&mut`.
//!
//! Absent: allocation, and large values on the stack.

pub mod blas;
pub mod kernels;
mod lu;
pub mod parts;
mod systems;

pub use lu::{inverse_mut, solve_mut};
pub use systems::{inverse, solve};
