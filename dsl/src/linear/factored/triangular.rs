//! Solves with a triangular matrix, of which only the triangle is read. If the diagonal has a zero, the result is
//! none (or `false`, with an unusable `b`).

use nalgebra::SMatrix;

use crate::library;
use crate::linear::kernels::{
    solve_lower_mut, solve_upper_mut, tr_solve_lower_mut, tr_solve_upper_mut,
};
use crate::math::Real;

#[library(TriangularCompanions)]
impl<T: Real, const N: usize> SMatrix<T, N, N> {
    /// The solution of `a x = b` with the lower triangle of `a`.
    pub fn solve_lower_triangular<const K: usize>(
        a: &Self,
        b: &SMatrix<T, N, K>,
    ) -> Option<SMatrix<T, N, K>> {
        let mut x = *b;
        if solve_lower_mut(a, &mut x) { Some(x) } else { None }
    }

    /// The solution of `a x = b` with the upper triangle of `a`.
    pub fn solve_upper_triangular<const K: usize>(
        a: &Self,
        b: &SMatrix<T, N, K>,
    ) -> Option<SMatrix<T, N, K>> {
        let mut x = *b;
        if solve_upper_mut(a, &mut x) { Some(x) } else { None }
    }

    /// The solution of `aᵀ x = b` with the lower triangle of `a`.
    #[method(tr_solve_lower_triangular, ad_solve_lower_triangular)]
    pub fn tr_solve_lower_triangular<const K: usize>(
        a: &Self,
        b: &SMatrix<T, N, K>,
    ) -> Option<SMatrix<T, N, K>> {
        let mut x = *b;
        if tr_solve_lower_mut(a, &mut x) { Some(x) } else { None }
    }

    /// The solution of `aᵀ x = b` with the upper triangle of `a`.
    #[method(tr_solve_upper_triangular, ad_solve_upper_triangular)]
    pub fn tr_solve_upper_triangular<const K: usize>(
        a: &Self,
        b: &SMatrix<T, N, K>,
    ) -> Option<SMatrix<T, N, K>> {
        let mut x = *b;
        if tr_solve_upper_mut(a, &mut x) { Some(x) } else { None }
    }

    /// Solves `a x = b` in place of `b`, with the lower triangle of `a`.
    pub fn solve_lower_triangular_mut<const K: usize>(a: &Self, b: &mut SMatrix<T, N, K>) -> bool {
        for column in 0..K {
            for k in 0..N {
                let diagonal = a[(k, k)];
                if diagonal == T::ZERO {
                    return false;
                }
                let value = b[(k, column)] / diagonal;
                b[(k, column)] = value;
                for row in k + 1..N {
                    b[(row, column)] = -value * a[(row, k)] + b[(row, column)];
                }
            }
        }
        true
    }

    /// Solves `a x = b` in place of `b`, with the upper triangle of `a`.
    pub fn solve_upper_triangular_mut<const K: usize>(a: &Self, b: &mut SMatrix<T, N, K>) -> bool {
        for column in 0..K {
            for k in (0..N).rev() {
                let diagonal = a[(k, k)];
                if diagonal == T::ZERO {
                    return false;
                }
                let value = b[(k, column)] / diagonal;
                b[(k, column)] = value;
                for row in 0..k {
                    b[(row, column)] = -value * a[(row, k)] + b[(row, column)];
                }
            }
        }
        true
    }
}
