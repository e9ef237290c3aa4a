//! Vectors and matrices written out: [`vector!`](crate::vector) and [`matrix!`](crate::matrix).

use nalgebra::{SMatrix, Scalar};

/// A vector of these elements, of any length.
///
/// ```
/// use bessemer::prelude::*;
///
/// let v = vector![1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0];
/// assert_eq!(v.sum(), 28.0);
/// ```
#[macro_export]
macro_rules! vector {
    ($($element:expr),* $(,)?) => { $crate::linear::by_rows([$([$element]),*]) };
}

/// A matrix of these elements: rows end with a semicolon.
///
/// ```
/// use bessemer::prelude::*;
///
/// let a = matrix![1.0, 2.0; 3.0, 4.0];
/// assert_eq!(a, Matrix2::new(1.0, 2.0, 3.0, 4.0));
/// ```
#[macro_export]
macro_rules! matrix {
    ($($($element:expr),+);* $(;)?) => { $crate::linear::by_rows([$([$($element),+]),*]) };
}

/// Returns the matrix with these rows: the equivalent of [`vector!`](crate::vector) and [`matrix!`](crate::matrix).
#[doc(hidden)]
pub fn by_rows<T: Scalar, const R: usize, const C: usize>(rows: [[T; C]; R]) -> SMatrix<T, R, C> {
    SMatrix::from_fn(|row, column| rows[row][column].clone())
}

/// Carrier of the companion of [`by_rows`].
#[doc(hidden)]
#[allow(non_camel_case_types)]
pub struct by_rows {}
