//! The companions of linear algebra that is a function of its own in the C.

#![allow(missing_docs)]

use alloc::borrow::ToOwned;

use bessemer_ir::tree;
use nalgebra::{SMatrix, SVector, Scalar};

use super::builtin::markers;
use super::slot::ScalarType;
use super::{Builder, Called, Callee};
use crate::linear::{blas, inverse, inverse_mut, kernels, parts, solve_mut};
use crate::math::Real;

markers! {
    CholeskyMut: "cholesky_mut"; CholeskySolveMut: "cholesky_solve_mut";
    SolveLowerMut: "solve_lower_mut"; SolveUpperMut: "solve_upper_mut";
    TrSolveLowerMut: "tr_solve_lower_mut"; TrSolveUpperMut: "tr_solve_upper_mut";
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

impl kernels::cholesky_mut {
    pub fn __call<T: ScalarType, const N: usize>(
        _a: &mut SMatrix<T, N, N>,
    ) -> Called<CholeskyMut, bool> {
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

/// What a companion that is a function of the DSL returns: it names no reference.
macro_rules! told {
    (use<$($kept:ident),*> $result:ty) => { Called<impl Callee + use<$($kept),*>, $result> };
}

/// Methods of matrices that are functions of the DSL.
pub trait PartBuiltins<T, const R: usize, const C: usize>: Sized {
    fn __b_sum(&self) -> told!(use<Self, T, R, C> T);
    fn __b_mean(&self) -> told!(use<Self, T, R, C> T);
    fn __b_amax(&self) -> told!(use<Self, T, R, C> T);
    fn __b_amin(&self) -> told!(use<Self, T, R, C> T);
    fn __b_normalize(&self) -> told!(use<Self, T, R, C> Self);
    fn __b_normalize_mut(&mut self) -> told!(use<Self, T, R, C> T);
    fn __b_lower_triangle(&self) -> told!(use<Self, T, R, C> Self);
    fn __b_upper_triangle(&self) -> told!(use<Self, T, R, C> Self);
    fn __b_gemm<const K: usize>(
        &mut self,
        alpha: T,
        a: &SMatrix<T, R, K>,
        b: &SMatrix<T, K, C>,
        beta: T,
    ) -> told!(use<Self, T, R, C, K> ());
    fn __b_ger(
        &mut self,
        alpha: T,
        x: &SVector<T, R>,
        y: &SVector<T, C>,
        beta: T,
    ) -> told!(use<Self, T, R, C> ());
}

impl<T: Real, const R: usize, const C: usize> PartBuiltins<T, R, C> for SMatrix<T, R, C> {
    fn __b_sum(&self) -> told!(use<T, R, C> T) {
        parts::sum::__call(self)
    }
    fn __b_mean(&self) -> told!(use<T, R, C> T) {
        parts::mean::__call(self)
    }
    fn __b_amax(&self) -> told!(use<T, R, C> T) {
        parts::amax::__call(self)
    }
    fn __b_amin(&self) -> told!(use<T, R, C> T) {
        parts::amin::__call(self)
    }
    fn __b_normalize(&self) -> told!(use<T, R, C> Self) {
        parts::normalize::__call(self)
    }
    fn __b_normalize_mut(&mut self) -> told!(use<T, R, C> T) {
        parts::normalize_mut::__call(self)
    }
    fn __b_lower_triangle(&self) -> told!(use<T, R, C> Self) {
        parts::lower_triangle::__call(self)
    }
    fn __b_upper_triangle(&self) -> told!(use<T, R, C> Self) {
        parts::upper_triangle::__call(self)
    }
    fn __b_gemm<const K: usize>(
        &mut self,
        alpha: T,
        a: &SMatrix<T, R, K>,
        b: &SMatrix<T, K, C>,
        beta: T,
    ) -> told!(use<T, R, C, K> ()) {
        blas::gemm::__call(self, alpha, a, b, beta)
    }
    fn __b_ger(
        &mut self,
        alpha: T,
        x: &SVector<T, R>,
        y: &SVector<T, C>,
        beta: T,
    ) -> told!(use<T, R, C> ()) {
        blas::ger::__call(self, alpha, x, y, beta)
    }
}

/// Methods of vectors that are functions of the DSL.
pub trait VectorPartBuiltins<T, const N: usize>: Sized {
    fn __b_gemv<const K: usize>(
        &mut self,
        alpha: T,
        a: &SMatrix<T, N, K>,
        x: &SVector<T, K>,
        beta: T,
    ) -> told!(use<Self, T, N, K> ());
    fn __b_axpy(&mut self, alpha: T, x: &Self, beta: T) -> told!(use<Self, T, N> ());
}

impl<T: Real, const N: usize> VectorPartBuiltins<T, N> for SVector<T, N> {
    fn __b_gemv<const K: usize>(
        &mut self,
        alpha: T,
        a: &SMatrix<T, N, K>,
        x: &SVector<T, K>,
        beta: T,
    ) -> told!(use<T, N, K> ()) {
        blas::gemv::__call(self, alpha, a, x, beta)
    }
    fn __b_axpy(&mut self, alpha: T, x: &Self, beta: T) -> told!(use<T, N> ()) {
        blas::axpy::__call(self, alpha, x, beta)
    }
}

/// Methods of square matrices that are functions of the DSL.
pub trait SquarePartBuiltins<T, const N: usize>: Sized {
    fn __b_try_inverse(self) -> told!(use<Self, T, N> Option<Self>);
    fn __b_trace(&self) -> told!(use<Self, T, N> T);
    fn __b_diagonal(&self) -> told!(use<Self, T, N> SVector<T, N>);
    fn __b_from_diagonal(diagonal: &SVector<T, N>) -> told!(use<Self, T, N> Self);
}

impl<T: Real, const N: usize> SquarePartBuiltins<T, N> for SMatrix<T, N, N> {
    fn __b_try_inverse(self) -> told!(use<T, N> Option<Self>) {
        inverse::__call(&self)
    }
    fn __b_trace(&self) -> told!(use<T, N> T) {
        parts::trace::__call(self)
    }
    fn __b_diagonal(&self) -> told!(use<T, N> SVector<T, N>) {
        parts::diagonal::__call(self)
    }
    fn __b_from_diagonal(diagonal: &SVector<T, N>) -> told!(use<T, N> Self) {
        parts::from_diagonal::__call(diagonal)
    }
}
