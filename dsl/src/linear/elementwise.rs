//! Operations on each element: nalgebra's methods of these names, in its order of operations, written in
//! the DSL for the C.

use nalgebra::{SMatrix, SVector};

use super::blas::axpy;
use crate::function;
use crate::math::{Real, real};

/// The magnitude of each element.
#[function]
pub fn abs<T: Real, const R: usize, const C: usize>(a: &SMatrix<T, R, C>) -> SMatrix<T, R, C> {
    let mut magnitudes = *a;
    for column in 0..C {
        for row in 0..R {
            magnitudes[(row, column)] = a[(row, column)].abs();
        }
    }
    magnitudes
}

/// Each element plus `b`.
#[function]
pub fn add_scalar<T: Real, const R: usize, const C: usize>(
    a: &SMatrix<T, R, C>,
    b: T,
) -> SMatrix<T, R, C> {
    a + SMatrix::<T, R, C>::from_element(b)
}

/// Adds `b` to each element.
#[function]
pub fn add_scalar_mut<T: Real, const R: usize, const C: usize>(a: &mut SMatrix<T, R, C>, b: T) {
    *a += SMatrix::<T, R, C>::from_element(b);
}

/// Turns the sign of each element.
#[function]
pub fn neg_mut<T: Real, const R: usize, const C: usize>(a: &mut SMatrix<T, R, C>) {
    *a = -*a;
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

/// Multiplies each element by `factor`.
#[function]
pub fn scale_mut<T: Real, const R: usize, const C: usize>(a: &mut SMatrix<T, R, C>, factor: T) {
    *a *= factor;
}

/// Divides each element by `divisor`.
#[function]
pub fn unscale_mut<T: Real, const R: usize, const C: usize>(a: &mut SMatrix<T, R, C>, divisor: T) {
    *a /= divisor;
}

/// Multiplies each element by that of `b`.
#[function]
pub fn component_mul_assign<T: Real, const R: usize, const C: usize>(
    a: &mut SMatrix<T, R, C>,
    b: &SMatrix<T, R, C>,
) {
    *a = a.component_mul(b);
}

/// Divides each element by that of `b`.
#[function]
pub fn component_div_assign<T: Real, const R: usize, const C: usize>(
    a: &mut SMatrix<T, R, C>,
    b: &SMatrix<T, R, C>,
) {
    *a = a.component_div(b);
}

/// `y = alpha (a ∘ b) + beta y`, each element. Where `beta` is zero, what was there is not read.
#[function]
pub fn cmpy<T: Real, const R: usize, const C: usize>(
    y: &mut SMatrix<T, R, C>,
    alpha: T,
    a: &SMatrix<T, R, C>,
    b: &SMatrix<T, R, C>,
    beta: T,
) {
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

/// `y = alpha (a / b) + beta y`, each element. Where `beta` is zero, what was there is not read.
#[function]
pub fn cdpy<T: Real, const R: usize, const C: usize>(
    y: &mut SMatrix<T, R, C>,
    alpha: T,
    a: &SMatrix<T, R, C>,
    b: &SMatrix<T, R, C>,
    beta: T,
) {
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

/// From `a` at `t` 0 to `b` at `t` 1.
#[function]
pub fn lerp<T: Real, const N: usize>(a: &SVector<T, N>, b: &SVector<T, N>, t: T) -> SVector<T, N> {
    let mut between = *a;
    axpy(&mut between, t, b, T::ONE - t);
    between
}

/// The same numbers in another type, rounded if it is the shorter.
#[function]
pub fn cast<T: Real, U: Real, const R: usize, const C: usize>(
    a: &SMatrix<T, R, C>,
) -> SMatrix<U, R, C> {
    let mut other = SMatrix::<U, R, C>::zeros();
    for column in 0..C {
        for row in 0..R {
            other[(row, column)] = real(a[(row, column)].as_f64());
        }
    }
    other
}
