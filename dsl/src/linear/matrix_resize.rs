//! Functions whose result has another size than their operand, like nalgebra's methods of these names, written in the
//! DSL for the C.

use nalgebra::{SMatrix, SVector};

use crate::math::Real;
use crate::{function, library};

/// The product of each element of `a` with the whole of `b`.
#[function]
pub fn kronecker<
    T: Real,
    const R: usize,
    const C: usize,
    const R2: usize,
    const C2: usize,
    const ROWS: usize,
    const COLUMNS: usize,
>(
    a: &SMatrix<T, R, C>,
    b: &SMatrix<T, R2, C2>,
) -> SMatrix<T, ROWS, COLUMNS> {
    let mut product = SMatrix::<T, ROWS, COLUMNS>::zeros();
    for column in 0..COLUMNS {
        for row in 0..ROWS {
            product[(row, column)] =
                a[(row / R2 % R, column / C2 % C)] * b[(row % R2, column % C2)];
        }
    }
    product
}

/// Appends an element.
#[function]
pub fn push<T: Real, const N: usize, const ROWS: usize>(
    v: &SVector<T, N>,
    element: T,
) -> SVector<T, ROWS> {
    let mut longer = SVector::<T, ROWS>::from_element(element);
    for k in 0..N.min(ROWS) {
        longer[k] = v[k];
    }
    longer
}

/// Inserts a row of equal elements.
#[function]
pub fn insert_row<T: Real, const R: usize, const C: usize, const ROWS: usize>(
    a: &SMatrix<T, R, C>,
    at: usize,
    value: T,
) -> SMatrix<T, ROWS, C> {
    assert!(at <= R);
    let mut larger = SMatrix::<T, ROWS, C>::from_element(value);
    for column in 0..C {
        for row in 0..at {
            larger[(row, column)] = a[(row, column)];
        }
        for row in at..R {
            larger[(row + 1, column)] = a[(row, column)];
        }
    }
    larger
}

/// Inserts a column of equal elements.
#[function]
pub fn insert_column<T: Real, const R: usize, const C: usize, const COLUMNS: usize>(
    a: &SMatrix<T, R, C>,
    at: usize,
    value: T,
) -> SMatrix<T, R, COLUMNS> {
    assert!(at <= C);
    let mut larger = SMatrix::<T, R, COLUMNS>::from_element(value);
    for row in 0..R {
        for column in 0..at {
            larger[(row, column)] = a[(row, column)];
        }
        for column in at..C {
            larger[(row, column + 1)] = a[(row, column)];
        }
    }
    larger
}

/// Removes a row.
#[function]
pub fn remove_row<T: Real, const R: usize, const C: usize, const ROWS: usize>(
    a: &SMatrix<T, R, C>,
    at: usize,
) -> SMatrix<T, ROWS, C> {
    assert!(at < R);
    let mut smaller = SMatrix::<T, ROWS, C>::zeros();
    for column in 0..C {
        for row in 0..ROWS {
            smaller[(row, column)] = if row < at { a[(row, column)] } else { a[(row + 1, column)] };
        }
    }
    smaller
}

/// Removes a column.
#[function]
pub fn remove_column<T: Real, const R: usize, const C: usize, const COLUMNS: usize>(
    a: &SMatrix<T, R, C>,
    at: usize,
) -> SMatrix<T, R, COLUMNS> {
    assert!(at < C);
    let mut smaller = SMatrix::<T, R, COLUMNS>::zeros();
    for row in 0..R {
        for column in 0..COLUMNS {
            smaller[(row, column)] =
                if column < at { a[(row, column)] } else { a[(row, column + 1)] };
        }
    }
    smaller
}

#[library(FixedResizeCompanion)]
impl<T: Real, const R: usize, const C: usize> SMatrix<T, R, C> {
    /// Resized matrix: truncated, or filled with a value.
    #[by_value(a)]
    pub fn fixed_resize<const ROWS: usize, const COLUMNS: usize>(
        a: &Self,
        value: T,
    ) -> SMatrix<T, ROWS, COLUMNS> {
        let mut resized = SMatrix::<T, ROWS, COLUMNS>::from_element(value);
        for column in 0..C.min(COLUMNS) {
            for row in 0..R.min(ROWS) {
                resized[(row, column)] = a[(row, column)];
            }
        }
        resized
    }
}
