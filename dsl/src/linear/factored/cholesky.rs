//! Cholesky's factor of a positive definite matrix.

use nalgebra::{SMatrix, SVector};

use crate::linear::kernels::{cholesky_lower, cholesky_solve_mut};
use crate::math::Real;
use crate::{data, function};

/// The factor of a positive definite matrix.
#[data]
#[derive(Clone, Copy, Debug)]
pub struct CholeskyFactor<T: Real, const N: usize> {
    /// L; above the diagonal the elements of the matrix.
    factor: SMatrix<T, N, N>,
}

/// Factors a symmetric matrix, of which only the lower triangle is read; none unless it is positive definite.
#[function]
pub fn factored<T: Real, const N: usize>(a: &SMatrix<T, N, N>) -> Option<CholeskyFactor<T, N>> {
    let factor = cholesky_lower(a);
    // A root of what is positive; NaN where there is no factor.
    if factor[(0, 0)] > T::ZERO { Some(CholeskyFactor { factor }) } else { None }
}

#[data]
impl<T: Real, const N: usize> CholeskyFactor<T, N> {
    /// Solves for each column of `b`, in its place.
    pub fn solve_mut<const K: usize>(&self, b: &mut SMatrix<T, N, K>) {
        cholesky_solve_mut(&self.factor, b);
    }

    /// The solution for each column of `b`.
    pub fn solve<const K: usize>(&self, b: &SMatrix<T, N, K>) -> SMatrix<T, N, K> {
        let mut x = *b;
        cholesky_solve_mut(&self.factor, &mut x);
        x
    }

    /// The inverse.
    pub fn inverse(&self) -> SMatrix<T, N, N> {
        let mut inverse = SMatrix::<T, N, N>::identity();
        cholesky_solve_mut(&self.factor, &mut inverse);
        inverse
    }

    /// L.
    pub fn l(&self) -> SMatrix<T, N, N> {
        self.factor.lower_triangle()
    }

    /// L, with the elements of the matrix above the diagonal.
    pub fn unpack_dirty(&self) -> SMatrix<T, N, N> {
        self.factor
    }

    /// The determinant of the matrix.
    pub fn determinant(&self) -> T {
        let mut product = T::ONE;
        for k in 0..N {
            product *= self.factor[(k, k)];
        }
        product * product
    }

    /// Changes the factor to that of the matrix plus `sigma x xᵀ`.
    pub fn rank_one_update(&mut self, x: &SVector<T, N>, sigma: T) {
        let mut rest = *x;
        let mut beta = T::ONE;
        for k in 0..N {
            let diagonal = self.factor[(k, k)];
            let square = diagonal * diagonal;
            let part = rest[k];
            let added = sigma * (part * part);
            let gamma = square * beta + added;
            let updated = (square + added / beta).sqrt();
            self.factor[(k, k)] = updated;
            beta += added / square;
            let step = -part / diagonal;
            for row in k + 1..N {
                rest[row] = step * self.factor[(row, k)] + rest[row];
            }
            if gamma != T::ZERO {
                let share = updated * sigma / gamma * part;
                let growth = updated / diagonal;
                for row in k + 1..N {
                    let mut sum = share * rest[row];
                    if growth != T::ZERO {
                        sum += growth * self.factor[(row, k)];
                    }
                    self.factor[(row, k)] = sum;
                }
            }
        }
    }
}
