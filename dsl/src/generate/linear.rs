//! The companions of linear algebra that is a function of its own in the C.

#![allow(missing_docs)]

use alloc::borrow::ToOwned;

use bessemer_ir::tree;
use nalgebra::{SMatrix, Scalar};

use super::builtin::markers;
use super::slot::ScalarType;
use super::{Builder, Called, Callee};
use crate::linear::{inverse_mut, solve_mut};

markers! {
    SolveMut: "solve_mut"; InverseMut: "inverse_mut"; Determinant: "determinant";
}

impl solve_mut {
    pub fn __call<T: ScalarType, const N: usize, const K: usize>(
        _a: &mut SMatrix<T, N, N>,
        _b: &mut SMatrix<T, N, K>,
    ) -> Called<SolveMut, bool> {
        unreachable!()
    }
}

impl inverse_mut {
    pub fn __call<T: ScalarType, const N: usize>(
        _a: &mut SMatrix<T, N, N>,
    ) -> Called<InverseMut, bool> {
        unreachable!()
    }
}

/// Methods of square matrices.
pub trait SquareBuiltins<T>: Sized {
    fn __b_determinant(&self) -> Called<Determinant, T> {
        unreachable!()
    }
}

impl<T: ScalarType + Scalar, const N: usize> SquareBuiltins<T> for SMatrix<T, N, N> {}
