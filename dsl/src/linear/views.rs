//! Rows, columns and blocks of matrices: the C of nalgebra's views with these names.
//!
//! In the C, a view that is read is a copy; writing to a view writes to the matrix.

// An index that overflows by one is reported as by the check of nalgebra.
#![allow(clippy::int_plus_one)]

use nalgebra::{SMatrix, SVector};

use crate::element::Element;
use crate::library;

#[library(ViewCompanions)]
impl<T: Element, const R: usize, const C: usize> SMatrix<T, R, C> {
    /// A row of a matrix.
    pub fn row(a: &Self, row: usize) -> SMatrix<T, 1, C> {
        crate::__inside!(row + 1 <= R);
        let mut part = SMatrix::<T, 1, C>::repeat(T::ZERO);
        for column in 0..C {
            part[(0, column)] = a[(row, column)];
        }
        part
    }

    /// A column of a matrix.
    pub fn column(a: &Self, column: usize) -> SVector<T, R> {
        crate::__inside!(column + 1 <= C);
        let mut part = SVector::<T, R>::repeat(T::ZERO);
        for row in 0..R {
            part[row] = a[(row, column)];
        }
        part
    }

    /// The block of `ROWS` × `COLUMNS` elements whose first element is at this row and column.
    pub fn fixed_view<const ROWS: usize, const COLUMNS: usize>(
        a: &Self,
        row: usize,
        column: usize,
    ) -> SMatrix<T, ROWS, COLUMNS> {
        crate::__inside!(row + ROWS <= R);
        crate::__inside!(column + COLUMNS <= C);
        let mut part = SMatrix::<T, ROWS, COLUMNS>::repeat(T::ZERO);
        for j in 0..COLUMNS {
            for i in 0..ROWS {
                part[(i, j)] = a[(row + i, column + j)];
            }
        }
        part
    }

    /// The block of `ROWS` consecutive rows from `row` on.
    pub fn fixed_rows<const ROWS: usize>(a: &Self, row: usize) -> SMatrix<T, ROWS, C> {
        crate::__inside!(row + ROWS <= R);
        let mut part = SMatrix::<T, ROWS, C>::repeat(T::ZERO);
        for j in 0..C {
            for i in 0..ROWS {
                part[(i, j)] = a[(row + i, j)];
            }
        }
        part
    }

    /// The block of `COLUMNS` consecutive columns from `column` on.
    pub fn fixed_columns<const COLUMNS: usize>(a: &Self, column: usize) -> SMatrix<T, R, COLUMNS> {
        crate::__inside!(column + COLUMNS <= C);
        let mut part = SMatrix::<T, R, COLUMNS>::repeat(T::ZERO);
        for j in 0..COLUMNS {
            for i in 0..R {
                part[(i, j)] = a[(i, column + j)];
            }
        }
        part
    }

    /// Replaces a row.
    #[function(expand)]
    pub fn set_row(a: &mut Self, row: usize, part: &SMatrix<T, 1, C>) {
        crate::__inside!(row + 1 <= R);
        for column in 0..C {
            a[(row, column)] = part[(0, column)];
        }
    }

    /// Replaces a column.
    #[function(expand)]
    pub fn set_column(a: &mut Self, column: usize, part: &SVector<T, R>) {
        crate::__inside!(column + 1 <= C);
        for row in 0..R {
            a[(row, column)] = part[row];
        }
    }
}
