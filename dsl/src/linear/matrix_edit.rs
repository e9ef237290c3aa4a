//! Functions that fill, copy and exchange parts of matrices, as nalgebra's methods of these names do, written in
//! the DSL for the C.

use nalgebra::{SMatrix, SVector};

use crate::element::Element;
use crate::function;
use crate::math::Real;

/// Sets each element.
#[function]
pub fn fill<T: Element, const R: usize, const C: usize>(a: &mut SMatrix<T, R, C>, value: T) {
    *a = SMatrix::<T, R, C>::from_element(value);
}

/// Sets the diagonal.
#[function]
pub fn fill_diagonal<T: Element, const R: usize, const C: usize>(
    a: &mut SMatrix<T, R, C>,
    value: T,
) {
    for column in 0..C {
        for row in 0..R {
            if row == column {
                a[(row, column)] = value;
            }
        }
    }
}

/// Makes a matrix the identity.
#[function]
pub fn fill_with_identity<T: Real, const R: usize, const C: usize>(a: &mut SMatrix<T, R, C>) {
    for column in 0..C {
        for row in 0..R {
            a[(row, column)] = if row == column { T::ONE } else { T::ZERO };
        }
    }
}

/// Sets the elements of a row.
#[function(expand)]
pub fn fill_row<T: Element, const R: usize, const C: usize>(
    a: &mut SMatrix<T, R, C>,
    row: usize,
    value: T,
) {
    crate::__inside!(row < R);
    for column in 0..C {
        a[(row, column)] = value;
    }
}

/// Sets the elements of a column.
#[function(expand)]
pub fn fill_column<T: Element, const R: usize, const C: usize>(
    a: &mut SMatrix<T, R, C>,
    column: usize,
    value: T,
) {
    crate::__inside!(column < C);
    for row in 0..R {
        a[(row, column)] = value;
    }
}

/// Sets what is `shift` rows below the diagonal, and further down.
#[function]
pub fn fill_lower_triangle<T: Element, const R: usize, const C: usize>(
    a: &mut SMatrix<T, R, C>,
    value: T,
    shift: usize,
) {
    for column in 0..C {
        for row in column..R {
            if row - column >= shift {
                a[(row, column)] = value;
            }
        }
    }
}

/// Sets what is `shift` columns beside the diagonal, and further to the right.
#[function]
pub fn fill_upper_triangle<T: Element, const R: usize, const C: usize>(
    a: &mut SMatrix<T, R, C>,
    value: T,
    shift: usize,
) {
    for row in 0..R {
        for column in row..C {
            if column - row >= shift {
                a[(row, column)] = value;
            }
        }
    }
}

/// Sets the diagonal of a square matrix.
#[function]
pub fn set_diagonal<T: Element, const N: usize>(
    a: &mut SMatrix<T, N, N>,
    diagonal: &SVector<T, N>,
) {
    for k in 0..N {
        a[(k, k)] = diagonal[k];
    }
}

/// Copies what is above the diagonal to what is below.
#[function]
pub fn fill_lower_triangle_with_upper_triangle<T: Element, const N: usize>(
    a: &mut SMatrix<T, N, N>,
) {
    for column in 0..N {
        for row in column + 1..N {
            a[(row, column)] = a[(column, row)];
        }
    }
}

/// Copies what is below the diagonal to what is above.
#[function]
pub fn fill_upper_triangle_with_lower_triangle<T: Element, const N: usize>(
    a: &mut SMatrix<T, N, N>,
) {
    for column in 0..N {
        for row in 0..column {
            a[(row, column)] = a[(column, row)];
        }
    }
}

/// Exchanges two rows.
#[function(expand)]
pub fn swap_rows<T: Element, const R: usize, const C: usize>(
    a: &mut SMatrix<T, R, C>,
    one: usize,
    other: usize,
) {
    assert!(one < R && other < R);
    for column in 0..C {
        let held = a[(one, column)];
        a[(one, column)] = a[(other, column)];
        a[(other, column)] = held;
    }
}

/// Exchanges two columns.
#[function(expand)]
pub fn swap_columns<T: Element, const R: usize, const C: usize>(
    a: &mut SMatrix<T, R, C>,
    one: usize,
    other: usize,
) {
    assert!(one < C && other < C);
    for row in 0..R {
        let held = a[(row, one)];
        a[(row, one)] = a[(row, other)];
        a[(row, other)] = held;
    }
}

/// Exchanges two elements, each by row and column.
#[function]
pub fn swap<T: Element, const R: usize, const C: usize>(
    a: &mut SMatrix<T, R, C>,
    one: (usize, usize),
    other: (usize, usize),
) {
    let held = a[(one.0, one.1)];
    a[(one.0, one.1)] = a[(other.0, other.1)];
    a[(other.0, other.1)] = held;
}

/// Copies every element.
#[function]
pub fn copy_from<T: Element, const R: usize, const C: usize>(
    a: &mut SMatrix<T, R, C>,
    b: &SMatrix<T, R, C>,
) {
    *a = *b;
}

/// Copies every element of the transpose.
#[function]
pub fn tr_copy_from<T: Element, const R: usize, const C: usize>(
    a: &mut SMatrix<T, R, C>,
    b: &SMatrix<T, C, R>,
) {
    for column in 0..C {
        for row in 0..R {
            a[(row, column)] = b[(column, row)];
        }
    }
}

/// Copies every element to the transpose.
#[function]
pub fn transpose_to<T: Element, const R: usize, const C: usize>(
    a: &SMatrix<T, R, C>,
    b: &mut SMatrix<T, C, R>,
) {
    *b = a.transpose();
}

/// Turns a square matrix into its transpose.
#[function]
pub fn transpose_mut<T: Element, const N: usize>(a: &mut SMatrix<T, N, N>) {
    for column in 1..N {
        for row in 0..column {
            let held = a[(row, column)];
            a[(row, column)] = a[(column, row)];
            a[(column, row)] = held;
        }
    }
}
