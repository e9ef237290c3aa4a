//! Parts of matrices, and matrices from parts, like nalgebra's methods of these names, written in the DSL for the C.

use nalgebra::{SMatrix, SVector};

use super::matrix_edit::fill_diagonal;
use crate::element::{Element, Number};
use crate::math::{Real, real};
use crate::{function, library};

#[library(PartCompanions)]
impl<T: Element, const R: usize, const C: usize> SMatrix<T, R, C> {
    /// The lower triangle with the diagonal; zero above.
    pub fn lower_triangle(a: &Self) -> Self {
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

    /// The upper triangle with the diagonal; zero below.
    pub fn upper_triangle(a: &Self) -> Self {
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

    /// The matrix with `value` on the diagonal, and zero elsewhere.
    pub fn from_diagonal_element(value: T) -> Self {
        let mut matrix = SMatrix::<T, R, C>::from_element(T::ZERO);
        fill_diagonal(&mut matrix, value);
        matrix
    }

    /// Builds a matrix from its columns.
    pub fn from_columns(columns: &[SVector<T, R>; C]) -> Self {
        let mut matrix = SMatrix::<T, R, C>::from_element(T::ZERO);
        for column in 0..C {
            for row in 0..R {
                matrix[(row, column)] = columns[column][row];
            }
        }
        matrix
    }

    /// Builds a matrix from its rows.
    pub fn from_rows(rows: &[SMatrix<T, 1, C>; R]) -> Self {
        let mut matrix = SMatrix::<T, R, C>::from_element(T::ZERO);
        for column in 0..C {
            for row in 0..R {
                matrix[(row, column)] = rows[row][column];
            }
        }
        matrix
    }

    /// Builds a matrix from its elements in row order; `N` is the number of elements.
    pub fn from_row_slice<const N: usize>(elements: &[T; N]) -> Self {
        assert!(N == R * C);
        let mut matrix = SMatrix::<T, R, C>::from_element(T::ZERO);
        for column in 0..C {
            for row in 0..R {
                matrix[(row, column)] = elements[row * C + column];
            }
        }
        matrix
    }

    /// Builds a matrix from its elements in column order; `N` is the number of elements.
    pub fn from_column_slice<const N: usize>(elements: &[T; N]) -> Self {
        assert!(N == R * C);
        let mut matrix = SMatrix::<T, R, C>::from_element(T::ZERO);
        for column in 0..C {
            for row in 0..R {
                matrix[(row, column)] = elements[column * R + row];
            }
        }
        matrix
    }

    /// Numbers of rows and columns.
    pub fn shape(_a: &Self) -> (usize, usize) {
        (R, C)
    }

    /// Returns true if there are as many rows as columns.
    pub fn is_square(_a: &Self) -> bool {
        R == C
    }
}

#[library(TraceCompanion)]
impl<T: Number, const N: usize> SMatrix<T, N, N> {
    /// The sum of the diagonal elements.
    pub fn trace(a: &Self) -> T {
        let mut sum = T::ZERO;
        for k in 0..N {
            sum += a[(k, k)];
        }
        sum
    }
}

#[library(SquarePartCompanions)]
impl<T: Element, const N: usize> SMatrix<T, N, N> {
    /// The diagonal elements.
    pub fn diagonal(a: &Self) -> SVector<T, N> {
        let mut diagonal = SVector::<T, N>::from_element(T::ZERO);
        for k in 0..N {
            diagonal[k] = a[(k, k)];
        }
        diagonal
    }

    /// The matrix with this diagonal, and zero elsewhere.
    pub fn from_diagonal(diagonal: &SVector<T, N>) -> Self {
        let mut matrix = SMatrix::<T, N, N>::from_element(T::ZERO);
        for k in 0..N {
            matrix[(k, k)] = diagonal[k];
        }
        matrix
    }
}

#[library(IthCompanion)]
impl<T: Real, const N: usize> SVector<T, N> {
    /// The vector with `value` at `place`, and zero elsewhere.
    pub fn ith(place: usize, value: T) -> Self {
        let mut vector = SVector::<T, N>::zeros();
        vector[place] = value;
        vector
    }
}

#[library(SymmetricPartCompanion)]
impl<T: Real, const N: usize> SMatrix<T, N, N> {
    /// The mean of a matrix and its transpose.
    #[method(symmetric_part, hermitian_part)]
    pub fn symmetric_part(a: &Self) -> Self {
        let half: T = real(0.5);
        (a.transpose() + a) * half
    }
}

#[library(CrossMatrixCompanion)]
impl<T: Real> SVector<T, 3> {
    /// The matrix whose product with a vector is the cross product of `v` and that vector.
    pub fn cross_matrix(v: &Self) -> SMatrix<T, 3, 3> {
        let mut matrix = SMatrix::<T, 3, 3>::from_element(T::ZERO);
        matrix[(1, 0)] = v[2];
        matrix[(2, 0)] = -v[1];
        matrix[(0, 1)] = -v[2];
        matrix[(2, 1)] = v[0];
        matrix[(0, 2)] = v[1];
        matrix[(1, 2)] = -v[0];
        matrix
    }
}

/// The element of a 1 × 1 matrix.
#[function]
pub fn to_scalar<T: Element>(a: &SMatrix<T, 1, 1>) -> T {
    a[(0, 0)]
}
