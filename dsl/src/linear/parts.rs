//! Parts of matrices, and matrices of parts: what nalgebra's methods of these names give, written in the DSL
//! for the C.

use nalgebra::{SMatrix, SVector};

use super::matrix_edit::fill_diagonal;
use crate::element::{Element, Number};
use crate::function;
use crate::math::{Real, real};

/// What is on and below the diagonal; zero above.
#[function]
pub fn lower_triangle<T: Element, const R: usize, const C: usize>(
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
pub fn upper_triangle<T: Element, const R: usize, const C: usize>(
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
pub fn trace<T: Number, const N: usize>(a: &SMatrix<T, N, N>) -> T {
    let mut sum = T::ZERO;
    for k in 0..N {
        sum += a[(k, k)];
    }
    sum
}

/// The diagonal.
#[function]
pub fn diagonal<T: Element, const N: usize>(a: &SMatrix<T, N, N>) -> SVector<T, N> {
    let mut diagonal = SVector::<T, N>::from_element(T::ZERO);
    for k in 0..N {
        diagonal[k] = a[(k, k)];
    }
    diagonal
}

/// The matrix with this diagonal, and zero elsewhere.
#[function]
pub fn from_diagonal<T: Element, const N: usize>(diagonal: &SVector<T, N>) -> SMatrix<T, N, N> {
    let mut matrix = SMatrix::<T, N, N>::from_element(T::ZERO);
    for k in 0..N {
        matrix[(k, k)] = diagonal[k];
    }
    matrix
}

/// The matrix with `value` on the diagonal, and zero elsewhere.
#[function]
pub fn from_diagonal_element<T: Element, const R: usize, const C: usize>(
    value: T,
) -> SMatrix<T, R, C> {
    let mut matrix = SMatrix::<T, R, C>::from_element(T::ZERO);
    fill_diagonal(&mut matrix, value);
    matrix
}

/// The vector with `value` at `place`, and zero elsewhere.
#[function]
pub fn ith<T: Real, const N: usize>(place: usize, value: T) -> SVector<T, N> {
    let mut vector = SVector::<T, N>::zeros();
    vector[place] = value;
    vector
}

/// The matrix of these columns.
#[function]
pub fn from_columns<T: Element, const R: usize, const C: usize>(
    columns: &[SVector<T, R>; C],
) -> SMatrix<T, R, C> {
    let mut matrix = SMatrix::<T, R, C>::from_element(T::ZERO);
    for column in 0..C {
        for row in 0..R {
            matrix[(row, column)] = columns[column][row];
        }
    }
    matrix
}

/// The matrix of these rows.
#[function]
pub fn from_rows<T: Element, const R: usize, const C: usize>(
    rows: &[SMatrix<T, 1, C>; R],
) -> SMatrix<T, R, C> {
    let mut matrix = SMatrix::<T, R, C>::from_element(T::ZERO);
    for column in 0..C {
        for row in 0..R {
            matrix[(row, column)] = rows[row][column];
        }
    }
    matrix
}

/// The matrix of these elements, by rows; there must be as many as it has.
#[function]
pub fn from_row_slice<T: Element, const R: usize, const C: usize, const N: usize>(
    elements: &[T; N],
) -> SMatrix<T, R, C> {
    assert!(N == R * C);
    let mut matrix = SMatrix::<T, R, C>::from_element(T::ZERO);
    for column in 0..C {
        for row in 0..R {
            matrix[(row, column)] = elements[row * C + column];
        }
    }
    matrix
}

/// The matrix of these elements, by columns; there must be as many as it has.
#[function]
pub fn from_column_slice<T: Element, const R: usize, const C: usize, const N: usize>(
    elements: &[T; N],
) -> SMatrix<T, R, C> {
    assert!(N == R * C);
    let mut matrix = SMatrix::<T, R, C>::from_element(T::ZERO);
    for column in 0..C {
        for row in 0..R {
            matrix[(row, column)] = elements[column * R + row];
        }
    }
    matrix
}

/// The mean of a matrix and its transpose.
#[function]
pub fn symmetric_part<T: Real, const N: usize>(a: &SMatrix<T, N, N>) -> SMatrix<T, N, N> {
    let half: T = real(0.5);
    (a.transpose() + a) * half
}

/// The matrix whose product with a vector is the cross product of `v` and it.
#[function]
pub fn cross_matrix<T: Real>(v: &SVector<T, 3>) -> SMatrix<T, 3, 3> {
    let mut matrix = SMatrix::<T, 3, 3>::from_element(T::ZERO);
    matrix[(1, 0)] = v[2];
    matrix[(2, 0)] = -v[1];
    matrix[(0, 1)] = -v[2];
    matrix[(2, 1)] = v[0];
    matrix[(0, 2)] = v[1];
    matrix[(1, 2)] = -v[0];
    matrix
}

/// How many rows, and how many columns.
#[function]
pub fn shape<T: Element, const R: usize, const C: usize>(_a: &SMatrix<T, R, C>) -> (usize, usize) {
    (R, C)
}

/// Whether there are as many rows as columns.
#[function]
pub fn is_square<T: Element, const R: usize, const C: usize>(_a: &SMatrix<T, R, C>) -> bool {
    R == C
}

/// The element of a matrix that has one.
#[function]
pub fn to_scalar<T: Element>(a: &SMatrix<T, 1, 1>) -> T {
    a[(0, 0)]
}
