//! Products that add to what is there: what nalgebra's methods of these names compute, in its order,
//! written in the DSL for the C.
//!
//! Where `beta` is zero, what was there is not read: a NaN in it goes.

use nalgebra::{SMatrix, SVector};

use crate::function;
use crate::math::Real;

/// `y = alpha a b + beta y`.
#[function]
pub fn gemm<T: Real, const R: usize, const K: usize, const C: usize>(
    y: &mut SMatrix<T, R, C>,
    alpha: T,
    a: &SMatrix<T, R, K>,
    b: &SMatrix<T, K, C>,
    beta: T,
) {
    for column in 0..C {
        for row in 0..R {
            let mut sum = alpha * a[(row, 0)] * b[(0, column)];
            if beta != T::ZERO {
                sum += beta * y[(row, column)];
            }
            for k in 1..K {
                sum += alpha * a[(row, k)] * b[(k, column)];
            }
            y[(row, column)] = sum;
        }
    }
}

/// `y = alpha a x + beta y`.
#[function]
pub fn gemv<T: Real, const R: usize, const K: usize>(
    y: &mut SVector<T, R>,
    alpha: T,
    a: &SMatrix<T, R, K>,
    x: &SVector<T, K>,
    beta: T,
) {
    for row in 0..R {
        let mut sum = alpha * a[(row, 0)] * x[0];
        if beta != T::ZERO {
            sum += beta * y[row];
        }
        for k in 1..K {
            sum += alpha * a[(row, k)] * x[k];
        }
        y[row] = sum;
    }
}

/// `a = alpha x yᵀ + beta a`.
#[function]
pub fn ger<T: Real, const R: usize, const C: usize>(
    a: &mut SMatrix<T, R, C>,
    alpha: T,
    x: &SVector<T, R>,
    y: &SVector<T, C>,
    beta: T,
) {
    for column in 0..C {
        let factor = alpha * y[column];
        for row in 0..R {
            let mut sum = factor * x[row];
            if beta != T::ZERO {
                sum += beta * a[(row, column)];
            }
            a[(row, column)] = sum;
        }
    }
}

/// `y = alpha x + beta y`.
#[function]
pub fn axpy<T: Real, const N: usize>(y: &mut SVector<T, N>, alpha: T, x: &SVector<T, N>, beta: T) {
    for k in 0..N {
        let mut sum = alpha * x[k];
        if beta != T::ZERO {
            sum += beta * y[k];
        }
        y[k] = sum;
    }
}
