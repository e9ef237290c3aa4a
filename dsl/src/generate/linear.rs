//! The companions of linear algebra that is a function of its own in the C.

#![allow(missing_docs)]

use bessemer_ir::KernelRoutine;
use bessemer_ir::tree::{self, MatrixMethod};
use nalgebra::{SMatrix, SVector, Scalar};

use super::builder::{Builder, Callee};
use super::builtin::markers;
use super::numbers::FromBuiltin;
use super::slot::{Called, ScalarType};
use crate::linear::{by_rows, inverse_mut, kernels, solve_into, solve_mut};

markers! {
    CholeskyMut: Kernel(KernelRoutine::Cholesky); CholeskyLower: Kernel(KernelRoutine::CholeskyLower); CholeskySolveMut: Kernel(KernelRoutine::CholeskySolve);
    SolveLowerMut: Kernel(KernelRoutine::SolveLower); SolveUpperMut: Kernel(KernelRoutine::SolveUpper);
    TrSolveLowerMut: Kernel(KernelRoutine::TrSolveLower); TrSolveUpperMut: Kernel(KernelRoutine::TrSolveUpper);
    ByRows: Matrix(MatrixMethod::ByRows); FromArray: Matrix(MatrixMethod::FromArray);
    SolveMut: Kernel(KernelRoutine::LuSolve); SolveInto: Kernel(KernelRoutine::Solve); InverseMut: Kernel(KernelRoutine::Inverse); Determinant: Kernel(KernelRoutine::Determinant);
}

impl by_rows {
    pub fn __call<T: ScalarType + Scalar, const R: usize, const C: usize>(
        _rows: [[T; C]; R],
    ) -> Called<ByRows, SMatrix<T, R, C>> {
        unreachable!()
    }
}

impl solve_mut {
    pub fn __call<T: ScalarType, const N: usize, const K: usize>(
        _a: &mut SMatrix<T, N, N>,
        _b: &mut SMatrix<T, N, K>,
    ) -> Called<SolveMut, bool> {
        unreachable!()
    }
}

impl solve_into {
    pub fn __call<T: ScalarType, const N: usize, const K: usize>(
        _a: &SMatrix<T, N, N>,
        _b: &mut SMatrix<T, N, K>,
    ) -> Called<SolveInto, bool> {
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

impl kernels::cholesky_mut {
    pub fn __call<T: ScalarType, const N: usize>(
        _a: &mut SMatrix<T, N, N>,
    ) -> Called<CholeskyMut, bool> {
        unreachable!()
    }
}

impl kernels::cholesky_lower {
    pub fn __call<T: ScalarType + Scalar, const N: usize>(
        _a: &SMatrix<T, N, N>,
    ) -> Called<CholeskyLower, SMatrix<T, N, N>> {
        unreachable!()
    }
}

impl kernels::determinant {
    pub fn __call<T: ScalarType, const N: usize>(_a: &SMatrix<T, N, N>) -> Called<Determinant, T> {
        unreachable!()
    }
}

macro_rules! solvers {
    ($($name:ident: $marker:ident -> $result:ty;)*) => {$(
        impl kernels::$name {
            pub fn __call<T: ScalarType, const N: usize, const K: usize>(
                _a: &SMatrix<T, N, N>,
                _b: &mut SMatrix<T, N, K>,
            ) -> Called<$marker, $result> {
                unreachable!()
            }
        }
    )*};
}

solvers! {
    cholesky_solve_mut: CholeskySolveMut -> ();
    solve_lower_mut: SolveLowerMut -> bool;
    solve_upper_mut: SolveUpperMut -> bool;
    tr_solve_lower_mut: TrSolveLowerMut -> bool;
    tr_solve_upper_mut: TrSolveUpperMut -> bool;
}

/// Methods of square matrices.
pub trait SquareBuiltins<T>: Sized {
    fn __b_determinant(&self) -> Called<Determinant, T> {
        unreachable!()
    }
}

impl<T: ScalarType + Scalar, const N: usize> SquareBuiltins<T> for SMatrix<T, N, N> {}

/// `Vector3::from([x, y, z])`, `Matrix2::from([[a, c], [b, d]])` by columns, and arrays of what they hold.
macro_rules! from_arrays {
    ($([$($n:ident),*] $matrix:ty: $array:ty;)*) => {$(
        impl<T: ScalarType + Scalar, $(const $n: usize),*> FromBuiltin<$array> for $matrix {
            type Marker = FromArray;
        }
        impl<T: ScalarType + Scalar, $(const $n: usize),*> FromBuiltin<$matrix> for $array {
            type Marker = FromArray;
        }
    )*};
}

from_arrays! {
    [N] SVector<T, N>: [T; N];
    [] SMatrix<T, 1, 2>: [T; 2];
    [] SMatrix<T, 1, 3>: [T; 3];
    [] SMatrix<T, 1, 4>: [T; 4];
    [] SMatrix<T, 1, 5>: [T; 5];
    [] SMatrix<T, 1, 6>: [T; 6];
    [R, C] SMatrix<T, R, C>: [[T; R]; C];
}
