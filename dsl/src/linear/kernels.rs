//! Routines that are kernels in the C, for the DSL's own functions.
//!
//! Natively each is nalgebra's routine, or has its order of operations.

use nalgebra::{Cholesky, Const, SMatrix};

use crate::math::Real;

/// Factors a symmetric matrix in place: the lower triangle becomes L, the rest is unchanged. Unless the matrix is
/// positive definite, the result is `false`, and the lower triangle is NaN.
pub fn cholesky_mut<T: Real, const N: usize>(a: &mut SMatrix<T, N, N>) -> bool {
    match Cholesky::new(*a) {
        Some(factors) => {
            *a = factors.unpack_dirty();
            true
        }
        None => {
            a.fill_lower_triangle(T::NAN, 0);
            false
        }
    }
}

/// Returns the factor of a symmetric matrix: L in the lower triangle, the elements of `a` above it. The lower
/// triangle is NaN unless `a` is positive definite.
pub fn cholesky_lower<T: Real, const N: usize>(a: &SMatrix<T, N, N>) -> SMatrix<T, N, N> {
    let mut lower = *a;
    cholesky_mut(&mut lower);
    lower
}

/// Solves `l lᵀ x = b` in place of `b`.
pub fn cholesky_solve_mut<T: Real, const N: usize, const K: usize>(
    l: &SMatrix<T, N, N>,
    b: &mut SMatrix<T, N, K>,
) {
    Cholesky::<T, Const<N>>::pack_dirty(*l).solve_mut(b);
}

macro_rules! triangular {
    ($($(#[$doc:meta])* $name:ident: $method:ident;)*) => {$(
        $(#[$doc])*
        /// Solves like nalgebra's method of this name; returns false, with NaN in `b`, if the diagonal has a zero.
        pub fn $name<T: Real, const N: usize, const K: usize>(
            a: &SMatrix<T, N, N>,
            b: &mut SMatrix<T, N, K>,
        ) -> bool {
            let solved = a.$method(b);
            if !solved {
                b.fill(T::NAN);
            }
            solved
        }
    )*};
}

triangular! {
    /// Solves `a x = b` in place of `b`, with the lower triangle of `a`.
    solve_lower_mut: solve_lower_triangular_mut;
    /// Solves `a x = b` in place of `b`, with the upper triangle of `a`.
    solve_upper_mut: solve_upper_triangular_mut;
    /// Solves `aᵀ x = b` in place of `b`, with the lower triangle of `a`.
    tr_solve_lower_mut: tr_solve_lower_triangular_mut;
    /// Solves `aᵀ x = b` in place of `b`, with the upper triangle of `a`.
    tr_solve_upper_mut: tr_solve_upper_triangular_mut;
}

/// The determinant: up to three rows by minors, above by elimination.
pub fn determinant<T: Real, const N: usize>(a: &SMatrix<T, N, N>) -> T {
    super::lu::determinant(a)
}

macro_rules! carriers {
    ($($name:ident)*) => {$(
        /// Carrier of the function's companion.
        #[doc(hidden)]
        #[allow(non_camel_case_types)]
        pub struct $name {}
    )*};
}

carriers! {
    cholesky_mut cholesky_lower cholesky_solve_mut determinant
    solve_lower_mut solve_upper_mut tr_solve_lower_mut tr_solve_upper_mut
}
