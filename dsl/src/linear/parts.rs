//! Sums and parts of matrices: what nalgebra's methods of these names compute, in its order, written in
//! the DSL for the C.

use nalgebra::{SMatrix, SVector};

use crate::function;
use crate::math::{Real, real};

/// The sum of all elements, by columns.
#[function]
pub fn sum<T: Real, const R: usize, const C: usize>(a: &SMatrix<T, R, C>) -> T {
    let mut sum = T::ZERO;
    for column in 0..C {
        for row in 0..R {
            sum += a[(row, column)];
        }
    }
    sum
}

/// The mean of all elements.
#[function]
pub fn mean<T: Real, const R: usize, const C: usize>(a: &SMatrix<T, R, C>) -> T {
    let count: T = real((R * C) as f64);
    sum(a) / count
}

/// The largest magnitude. A NaN hides what comes before it, as in nalgebra, and shows only at the end.
#[function]
pub fn amax<T: Real, const R: usize, const C: usize>(a: &SMatrix<T, R, C>) -> T {
    let mut largest = a[(0, 0)].abs();
    for column in 0..C {
        for row in 0..R {
            let magnitude = a[(row, column)].abs();
            largest = if largest >= magnitude { largest } else { magnitude };
        }
    }
    largest
}

/// The smallest magnitude. A NaN hides what comes before it, as in nalgebra, and shows only at the end.
#[function]
pub fn amin<T: Real, const R: usize, const C: usize>(a: &SMatrix<T, R, C>) -> T {
    let mut smallest = a[(0, 0)].abs();
    for column in 0..C {
        for row in 0..R {
            let magnitude = a[(row, column)].abs();
            smallest = if smallest <= magnitude { smallest } else { magnitude };
        }
    }
    smallest
}

/// Divided by its norm.
#[function]
pub fn normalize<T: Real, const R: usize, const C: usize>(
    a: &SMatrix<T, R, C>,
) -> SMatrix<T, R, C> {
    let norm = a.norm();
    a / norm
}

/// Divides a matrix by its norm, which is the result.
#[function]
pub fn normalize_mut<T: Real, const R: usize, const C: usize>(a: &mut SMatrix<T, R, C>) -> T {
    let norm = a.norm();
    *a /= norm;
    norm
}

/// What is on and below the diagonal; zero above.
#[function]
pub fn lower_triangle<T: Real, const R: usize, const C: usize>(
    a: &SMatrix<T, R, C>,
) -> SMatrix<T, R, C> {
    let mut triangle = *a;
    for column in 0..C {
        for row in 0..R {
            if row < column {
                triangle[(row, column)] = T::ZERO;
            }
        }
    }
    triangle
}

/// What is on and above the diagonal; zero below.
#[function]
pub fn upper_triangle<T: Real, const R: usize, const C: usize>(
    a: &SMatrix<T, R, C>,
) -> SMatrix<T, R, C> {
    let mut triangle = *a;
    for column in 0..C {
        for row in 0..R {
            if row > column {
                triangle[(row, column)] = T::ZERO;
            }
        }
    }
    triangle
}

/// The sum of the diagonal.
#[function]
pub fn trace<T: Real, const N: usize>(a: &SMatrix<T, N, N>) -> T {
    let mut sum = T::ZERO;
    for k in 0..N {
        sum += a[(k, k)];
    }
    sum
}

/// The diagonal.
#[function]
pub fn diagonal<T: Real, const N: usize>(a: &SMatrix<T, N, N>) -> SVector<T, N> {
    let mut diagonal = SVector::<T, N>::zeros();
    for k in 0..N {
        diagonal[k] = a[(k, k)];
    }
    diagonal
}

/// The matrix with this diagonal, and zero elsewhere.
#[function]
pub fn from_diagonal<T: Real, const N: usize>(diagonal: &SVector<T, N>) -> SMatrix<T, N, N> {
    let mut matrix = SMatrix::<T, N, N>::zeros();
    for k in 0..N {
        matrix[(k, k)] = diagonal[k];
    }
    matrix
}
