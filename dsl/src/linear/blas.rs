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

/// `y = alpha aᵀ x + beta y`, of `a` each column's `dot`.
#[function]
pub fn gemv_tr<T: Real, const R: usize, const C: usize>(
    y: &mut SVector<T, C>,
    alpha: T,
    a: &SMatrix<T, R, C>,
    x: &SVector<T, R>,
    beta: T,
) {
    let product = a.tr_mul(x);
    for k in 0..C {
        let mut sum = alpha * product[k];
        if beta != T::ZERO {
            sum += beta * y[k];
        }
        y[k] = sum;
    }
}

/// `y = alpha aᵀ b + beta y`, of each column of `a` and of `b` their `dot`.
#[function]
pub fn gemm_tr<T: Real, const R: usize, const K: usize, const C: usize>(
    y: &mut SMatrix<T, K, C>,
    alpha: T,
    a: &SMatrix<T, R, K>,
    b: &SMatrix<T, R, C>,
    beta: T,
) {
    let product = a.tr_mul(b);
    for column in 0..C {
        for row in 0..K {
            let mut sum = alpha * product[(row, column)];
            if beta != T::ZERO {
                sum += beta * y[(row, column)];
            }
            y[(row, column)] = sum;
        }
    }
}

/// `y = alpha x c + beta y`, each element times `c` after `alpha`.
#[function]
pub fn axcpy<T: Real, const N: usize>(
    y: &mut SVector<T, N>,
    alpha: T,
    x: &SVector<T, N>,
    c: T,
    beta: T,
) {
    for k in 0..N {
        let mut sum = alpha * x[k] * c;
        if beta != T::ZERO {
            sum += beta * y[k];
        }
        y[k] = sum;
    }
}

/// `a = alpha x yᵀ + beta a` on and below the diagonal; the rest stays.
#[function]
pub fn syger<T: Real, const N: usize>(
    a: &mut SMatrix<T, N, N>,
    alpha: T,
    x: &SVector<T, N>,
    y: &SVector<T, N>,
    beta: T,
) {
    for column in 0..N {
        let factor = alpha * y[column];
        for row in column..N {
            let mut sum = factor * x[row];
            if beta != T::ZERO {
                sum += beta * a[(row, column)];
            }
            a[(row, column)] = sum;
        }
    }
}

/// The sum of the products of each element of `a` with that of the transpose of `b`.
#[function]
pub fn tr_dot<T: Real, const R: usize, const C: usize>(
    a: &SMatrix<T, R, C>,
    b: &SMatrix<T, C, R>,
) -> T {
    let mut sum = T::ZERO;
    for row in 0..R {
        for column in 0..C {
            sum += a[(row, column)] * b[(column, row)];
        }
    }
    sum
}

/// `y = alpha rightᵀ mid right + beta y`.
#[function]
pub fn quadform<T: Real, const N: usize, const K: usize>(
    y: &mut SMatrix<T, K, K>,
    alpha: T,
    mid: &SMatrix<T, N, N>,
    right: &SMatrix<T, N, K>,
    beta: T,
) {
    gemm_tr(y, alpha, right, &(mid * right), beta);
}

/// `y = alpha left mid leftᵀ + beta y`.
#[function]
pub fn quadform_tr<T: Real, const N: usize, const K: usize>(
    y: &mut SMatrix<T, N, N>,
    alpha: T,
    left: &SMatrix<T, N, K>,
    mid: &SMatrix<T, K, K>,
    beta: T,
) {
    let product = left * mid;
    for k in 0..K {
        for column in 0..N {
            let factor = alpha * left[(column, k)];
            for row in 0..N {
                let mut sum = factor * product[(row, k)];
                if k > 0 {
                    sum += y[(row, column)];
                } else if beta != T::ZERO {
                    sum += beta * y[(row, column)];
                }
                y[(row, column)] = sum;
            }
        }
    }
}

/// The perpendicular product: the third component of the cross product of two vectors in a plane.
#[function]
pub fn perp<T: Real>(a: &SVector<T, 2>, b: &SVector<T, 2>) -> T {
    a[0] * b[1] - a[1] * b[0]
}

/// The product, written where it is wanted.
#[function]
pub fn mul_to<T: Real, const R: usize, const C: usize, const K: usize>(
    a: &SMatrix<T, R, C>,
    b: &SMatrix<T, C, K>,
    out: &mut SMatrix<T, R, K>,
) {
    *out = a * b;
}

/// The product of the transpose, column by column as [`SMatrix::tr_mul`], written where it is wanted.
#[function]
pub fn tr_mul_to<T: Real, const R: usize, const C: usize, const K: usize>(
    a: &SMatrix<T, R, C>,
    b: &SMatrix<T, R, K>,
    out: &mut SMatrix<T, C, K>,
) {
    *out = a.tr_mul(b);
}
