//! Functions that fill, copy and exchange parts of matrices, like nalgebra's methods of these names, written in the
//! DSL for the C.

use nalgebra::{SMatrix, SVector};

use crate::element::Element;
use crate::library;
use crate::math::Real;

#[library(EditCompanions)]
impl<T: Element, const R: usize, const C: usize> SMatrix<T, R, C> {
    /// Sets each element to `value`.
    pub fn fill(a: &mut Self, value: T) {
        *a = SMatrix::<T, R, C>::from_element(value);
    }

    /// Sets the elements of the diagonal to `value`.
    pub fn fill_diagonal(a: &mut Self, value: T) {
        for column in 0..C {
            for row in 0..R {
                if row == column {
                    a[(row, column)] = value;
                }
            }
        }
    }

    /// Sets the elements of a row to `value`.
    #[function(expand)]
    pub fn fill_row(a: &mut Self, row: usize, value: T) {
        crate::__inside!(row < R);
        for column in 0..C {
            a[(row, column)] = value;
        }
    }

    /// Sets the elements of a column to `value`.
    #[function(expand)]
    pub fn fill_column(a: &mut Self, column: usize, value: T) {
        crate::__inside!(column < C);
        for row in 0..R {
            a[(row, column)] = value;
        }
    }

    /// Sets the elements that are at least `shift` rows below the diagonal.
    pub fn fill_lower_triangle(a: &mut Self, value: T, shift: usize) {
        for column in 0..C {
            for row in column..R {
                if row - column >= shift {
                    a[(row, column)] = value;
                }
            }
        }
    }

    /// Sets the elements that are at least `shift` columns to the right of the diagonal.
    pub fn fill_upper_triangle(a: &mut Self, value: T, shift: usize) {
        for row in 0..R {
            for column in row..C {
                if column - row >= shift {
                    a[(row, column)] = value;
                }
            }
        }
    }

    /// Exchanges two rows.
    #[function(expand)]
    pub fn swap_rows(a: &mut Self, one: usize, other: usize) {
        assert!(one < R && other < R);
        for column in 0..C {
            let held = a[(one, column)];
            a[(one, column)] = a[(other, column)];
            a[(other, column)] = held;
        }
    }

    /// Exchanges two columns.
    #[function(expand)]
    pub fn swap_columns(a: &mut Self, one: usize, other: usize) {
        assert!(one < C && other < C);
        for row in 0..R {
            let held = a[(row, one)];
            a[(row, one)] = a[(row, other)];
            a[(row, other)] = held;
        }
    }

    /// Exchanges two elements, each by row and column.
    pub fn swap(a: &mut Self, one: (usize, usize), other: (usize, usize)) {
        let held = a[(one.0, one.1)];
        a[(one.0, one.1)] = a[(other.0, other.1)];
        a[(other.0, other.1)] = held;
    }

    /// Copies every element of `b`.
    pub fn copy_from(a: &mut Self, b: &Self) {
        *a = *b;
    }

    /// Copies every element of the transpose of `b`.
    pub fn tr_copy_from(a: &mut Self, b: &SMatrix<T, C, R>) {
        for column in 0..C {
            for row in 0..R {
                a[(row, column)] = b[(column, row)];
            }
        }
    }

    /// Copies the transpose to `b`.
    #[method(transpose_to, adjoint_to)]
    pub fn transpose_to(a: &Self, b: &mut SMatrix<T, C, R>) {
        *b = a.transpose();
    }
}

#[library(IdentityEditCompanion)]
impl<T: Real, const R: usize, const C: usize> SMatrix<T, R, C> {
    /// Sets a matrix to the identity.
    pub fn fill_with_identity(a: &mut Self) {
        for column in 0..C {
            for row in 0..R {
                a[(row, column)] = if row == column { T::ONE } else { T::ZERO };
            }
        }
    }
}

#[library(SquareEditCompanions)]
impl<T: Element, const N: usize> SMatrix<T, N, N> {
    /// Sets the diagonal of a square matrix.
    pub fn set_diagonal(a: &mut Self, diagonal: &SVector<T, N>) {
        for k in 0..N {
            a[(k, k)] = diagonal[k];
        }
    }

    /// Copies the elements above the diagonal to those below.
    pub fn fill_lower_triangle_with_upper_triangle(a: &mut Self) {
        for column in 0..N {
            for row in column + 1..N {
                a[(row, column)] = a[(column, row)];
            }
        }
    }

    /// Copies the elements below the diagonal to those above.
    pub fn fill_upper_triangle_with_lower_triangle(a: &mut Self) {
        for column in 0..N {
            for row in 0..column {
                a[(row, column)] = a[(column, row)];
            }
        }
    }

    /// Transposes a square matrix in place.
    #[method(transpose_mut, adjoint_mut)]
    pub fn transpose_mut(a: &mut Self) {
        for column in 1..N {
            for row in 0..column {
                let held = a[(row, column)];
                a[(row, column)] = a[(column, row)];
                a[(column, row)] = held;
            }
        }
    }
}
