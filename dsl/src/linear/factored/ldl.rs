//! L D Lᵀ of a symmetric matrix, without square roots: for covariances and other matrices that may be indefinite.
//!
//! nalgebra has no version without pivots. This one has its own order of operations: column by column; each element
//! subtracts the products with earlier columns in ascending order.

use nalgebra::{SMatrix, SVector};

use crate::math::Real;
use crate::{data, function};

/// The factors of a symmetric matrix.
#[data]
#[derive(Clone, Copy, Debug)]
pub struct Ldl<T: Real, const N: usize> {
    /// L, with ones on its diagonal.
    pub l: SMatrix<T, N, N>,
    /// The diagonal of D.
    pub d: SVector<T, N>,
}

/// Factors a symmetric matrix, of which only the lower triangle is read; none if an element of D is zero or not
/// finite.
#[function]
pub fn factored<T: Real, const N: usize>(a: &SMatrix<T, N, N>) -> Option<Ldl<T, N>> {
    let mut l = SMatrix::<T, N, N>::identity();
    let mut d = SVector::<T, N>::zeros();
    for column in 0..N {
        let mut left = a[(column, column)];
        for k in 0..column {
            left -= l[(column, k)] * l[(column, k)] * d[k];
        }
        if left == T::ZERO || !left.is_finite() {
            return None;
        }
        d[column] = left;
        for row in column + 1..N {
            let mut left = a[(row, column)];
            for k in 0..column {
                left -= l[(row, k)] * l[(column, k)] * d[k];
            }
            l[(row, column)] = left / d[column];
        }
    }
    Some(Ldl { l, d })
}

#[data]
impl<T: Real, const N: usize> Ldl<T, N> {
    /// The solution for each column of `b`.
    pub fn solve<const K: usize>(&self, b: &SMatrix<T, N, K>) -> SMatrix<T, N, K> {
        let mut x = *b;
        for column in 0..K {
            for k in 0..N {
                let value = x[(k, column)];
                for row in k + 1..N {
                    x[(row, column)] -= self.l[(row, k)] * value;
                }
            }
            for k in 0..N {
                x[(k, column)] /= self.d[k];
            }
            for k in (0..N).rev() {
                let value = x[(k, column)];
                for row in 0..k {
                    x[(row, column)] -= self.l[(k, row)] * value;
                }
            }
        }
        x
    }

    /// The inverse.
    pub fn inverse(&self) -> SMatrix<T, N, N> {
        self.solve(&SMatrix::<T, N, N>::identity())
    }

    /// The determinant.
    pub fn determinant(&self) -> T {
        let mut product = T::ONE;
        for k in 0..N {
            product *= self.d[k];
        }
        product
    }

    /// Returns true if the matrix is positive definite.
    pub fn is_positive(&self) -> bool {
        for k in 0..N {
            if self.d[k] <= T::ZERO {
                return false;
            }
        }
        true
    }
}
