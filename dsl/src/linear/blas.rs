//! Products that are added to a matrix, in the order of nalgebra's methods of these names, written in the DSL for the
//! C.
//!
//! If `beta` is zero, the old elements are not read, so a NaN in them has no effect.

use nalgebra::{SMatrix, SVector};

use crate::library;
use crate::math::Real;

#[library(ProductCompanions)]
impl<T: Real, const R: usize, const C: usize> SMatrix<T, R, C> {
    /// `y = alpha a b + beta y`.
    pub fn gemm<T: Real, const R: usize, const K: usize, const C: usize>(
        y: &mut Self,
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

    /// `a = alpha x yᵀ + beta a`.
    #[method(ger, gerc)]
    pub fn ger(a: &mut Self, alpha: T, x: &SVector<T, R>, y: &SVector<T, C>, beta: T) {
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

    /// The sum of the products of each element of `a` and the element of `b`'s transpose at its position.
    pub fn tr_dot(a: &Self, b: &SMatrix<T, C, R>) -> T {
        let mut sum = T::ZERO;
        for row in 0..R {
            for column in 0..C {
                sum += a[(row, column)] * b[(column, row)];
            }
        }
        sum
    }

    /// Writes the product to `out`.
    pub fn mul_to<const K: usize>(a: &Self, b: &SMatrix<T, C, K>, out: &mut SMatrix<T, R, K>) {
        *out = a * b;
    }

    /// Writes the product with the transpose to `out`, column by column as [`SMatrix::tr_mul`].
    pub fn tr_mul_to<const K: usize>(a: &Self, b: &SMatrix<T, R, K>, out: &mut SMatrix<T, C, K>) {
        *out = a.tr_mul(b);
    }
}

#[library(VectorProductCompanion)]
impl<T: Real, const R: usize> SVector<T, R> {
    /// `y = alpha a x + beta y`.
    pub fn gemv<const K: usize>(
        y: &mut Self,
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
}

#[library(SumOfVectorsCompanions)]
impl<T: Real, const N: usize> SVector<T, N> {
    /// `y = alpha x + beta y`.
    pub fn axpy(y: &mut Self, alpha: T, x: &Self, beta: T) {
        for k in 0..N {
            let mut sum = alpha * x[k];
            if beta != T::ZERO {
                sum += beta * y[k];
            }
            y[k] = sum;
        }
    }

    /// `y = alpha x c + beta y`, each element times `c` after `alpha`.
    pub fn axcpy(y: &mut Self, alpha: T, x: &Self, c: T, beta: T) {
        for k in 0..N {
            let mut sum = alpha * x[k] * c;
            if beta != T::ZERO {
                sum += beta * y[k];
            }
            y[k] = sum;
        }
    }
}

#[library(TransposedVectorProductCompanions)]
impl<T: Real, const C: usize> SVector<T, C> {
    /// `y = alpha aᵀ x + beta y`, by the `dot` of each column of `a`.
    #[method(gemv_tr, gemv_ad)]
    pub fn gemv_tr<T: Real, const R: usize, const C: usize>(
        y: &mut Self,
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
}

#[library(TransposedProductCompanions)]
impl<T: Real, const K: usize, const C: usize> SMatrix<T, K, C> {
    /// `y = alpha aᵀ b + beta y`, by the `dot` of each column of `a` and of `b`.
    #[method(gemm_tr, gemm_ad)]
    pub fn gemm_tr<T: Real, const R: usize, const K: usize, const C: usize>(
        y: &mut Self,
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
}

#[library(SquareProductCompanions)]
impl<T: Real, const N: usize> SMatrix<T, N, N> {
    /// `a = alpha x yᵀ + beta a` on and below the diagonal; the rest is unchanged.
    #[method(syger, hegerc)]
    pub fn syger(a: &mut Self, alpha: T, x: &SVector<T, N>, y: &SVector<T, N>, beta: T) {
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

    /// `y = alpha left mid leftᵀ + beta y`.
    pub fn quadform_tr<const K: usize>(
        y: &mut Self,
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
}

#[library(QuadraticFormCompanion)]
impl<T: Real, const K: usize> SMatrix<T, K, K> {
    /// `y = alpha rightᵀ mid right + beta y`.
    pub fn quadform<T: Real, const N: usize, const K: usize>(
        y: &mut Self,
        alpha: T,
        mid: &SMatrix<T, N, N>,
        right: &SMatrix<T, N, K>,
        beta: T,
    ) {
        gemm_tr(y, alpha, right, &(mid * right), beta);
    }
}

#[library(PerpCompanion)]
impl<T: Real> SVector<T, 2> {
    /// The perpendicular product: the third component of the cross product of two vectors in a plane.
    pub fn perp(a: &Self, b: &Self) -> T {
        a[0] * b[1] - a[1] * b[0]
    }
}
