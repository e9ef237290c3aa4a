//! Operations on each element, in the order of nalgebra's methods of these names, written in the DSL for the C.

use nalgebra::{SMatrix, SVector};

use super::blas::axpy;
use crate::math::{Real, real};
use crate::{function, library};

#[library(ElementwiseCompanions)]
impl<T: Real, const R: usize, const C: usize> SMatrix<T, R, C> {
    /// Each element plus `b`.
    pub fn add_scalar(a: &Self, b: T) -> Self {
        a + SMatrix::<T, R, C>::from_element(b)
    }

    /// Adds `b` to each element.
    pub fn add_scalar_mut(a: &mut Self, b: T) {
        *a += SMatrix::<T, R, C>::from_element(b);
    }

    /// Negates each element.
    pub fn neg_mut(a: &mut Self) {
        *a = -*a;
    }

    /// Multiplies each element by `factor`.
    #[method(scale_mut, mul_assign)]
    pub fn scale_mut(a: &mut Self, factor: T) {
        *a *= factor;
    }

    /// Divides each element by `divisor`.
    #[method(unscale_mut, div_assign)]
    pub fn unscale_mut(a: &mut Self, divisor: T) {
        *a /= divisor;
    }

    /// Multiplies each element by the element of `b` at its position.
    pub fn component_mul_assign(a: &mut Self, b: &Self) {
        *a = a.component_mul(b);
    }

    /// Divides each element by the element of `b` at its position.
    pub fn component_div_assign(a: &mut Self, b: &Self) {
        *a = a.component_div(b);
    }

    /// `y = alpha (a ∘ b) + beta y`, each element. If `beta` is zero, the old elements are not read.
    pub fn cmpy(y: &mut Self, alpha: T, a: &Self, b: &Self, beta: T) {
        for column in 0..C {
            for row in 0..R {
                let mut sum = alpha * (a[(row, column)] * b[(row, column)]);
                if beta != T::ZERO {
                    sum = beta * y[(row, column)] + sum;
                }
                y[(row, column)] = sum;
            }
        }
    }

    /// `y = alpha (a / b) + beta y`, each element. If `beta` is zero, the old elements are not read.
    pub fn cdpy(y: &mut Self, alpha: T, a: &Self, b: &Self, beta: T) {
        for column in 0..C {
            for row in 0..R {
                let mut sum = alpha * (a[(row, column)] / b[(row, column)]);
                if beta != T::ZERO {
                    sum = beta * y[(row, column)] + sum;
                }
                y[(row, column)] = sum;
            }
        }
    }

    /// Conversion to another number type, rounded if it is shorter.
    #[by_value(a)]
    pub fn cast<U: Real>(a: &Self) -> SMatrix<U, R, C> {
        let mut other = SMatrix::<U, R, C>::zeros();
        for column in 0..C {
            for row in 0..R {
                other[(row, column)] = real(a[(row, column)].as_f64());
            }
        }
        other
    }
}

/// Adds another matrix.
#[function(expand)]
pub fn add_assign<T: Real, const R: usize, const C: usize>(
    a: &mut SMatrix<T, R, C>,
    b: &SMatrix<T, R, C>,
) {
    *a += b;
}

/// Subtracts another matrix.
#[function(expand)]
pub fn sub_assign<T: Real, const R: usize, const C: usize>(
    a: &mut SMatrix<T, R, C>,
    b: &SMatrix<T, R, C>,
) {
    *a -= b;
}

#[library(LerpCompanion)]
impl<T: Real, const N: usize> SVector<T, N> {
    /// Linear interpolation: `a` for `t` = 0, `b` for `t` = 1.
    pub fn lerp(a: &Self, b: &Self, t: T) -> Self {
        let mut between = *a;
        axpy(&mut between, t, b, T::ONE - t);
        between
    }
}
