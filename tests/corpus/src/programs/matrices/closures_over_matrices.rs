//! Closures over the elements of matrices. `map`, `zip_map`, `apply`, `fold` and similar methods become loops by
//! columns, as in nalgebra; `from_fn` and `map_with_location` pass the row and the column.

use bessemer::prelude::*;

/// The matrix with each element limited in magnitude.
#[function]
pub fn limited(a: &Matrix3<f64>, limit: f64) -> Matrix3<f64> {
    a.map(|x| if x > limit { limit } else { x })
}

/// A weighted mean of two images.
#[function]
pub fn blended(a: &Matrix3<f32>, b: &Matrix3<f32>, share: f32) -> Matrix3<f32> {
    a.zip_map(b, |x, y| x + (y - x) * share)
}

/// The larger of two elements for each position; a NaN is ignored.
#[function]
pub fn larger(a: &Matrix2<f64>, b: &Matrix2<f64>) -> Matrix2<f64> {
    a.zip_map(b, f64::max)
}

/// Moves towards a goal; each component changes by at most `most`.
#[function]
pub fn step(position: &mut Vector3<f64>, goal: &Vector3<f64>, most: f64) {
    position.zip_apply(goal, |x, y| {
        let way = y - *x;
        *x += if way > most { most } else { way };
    });
}

/// Rounds in place; returns the number of negative elements.
#[function]
pub fn rounded(a: &mut SMatrix<f32, 2, 4>) -> u32 {
    a.apply(|x| *x = x.floor());
    a.fold(0, |count, x| if x < 0.0 { count + 1 } else { count })
}

/// The matrix of the second difference.
#[function]
pub fn second_difference() -> SMatrix<f64, 4, 4> {
    SMatrix::<f64, 4, 4>::from_fn(|row, column| {
        if row == column {
            2.0
        } else if row + 1 == column || column + 1 == row {
            -1.0
        } else {
            0.0
        }
    })
}

/// Reduces the elements far from the diagonal.
#[function]
pub fn faded(a: &Matrix3<f64>) -> Matrix3<f64> {
    a.map_with_location(|row, column, x| if row > column { x / ((row - column) as f64 + 1.0) } else { x })
}

/// The sum of the products of two matrices' elements, and of the squares of one.
#[function]
pub fn inner(a: &Matrix2<f64>, b: &Matrix2<f64>) -> (f64, f64) {
    let both = a.zip_fold(b, 0.0, |sum, x, y| sum + x * y);
    let squares = a.iter().map(|x| x * x).sum();
    (both, squares)
}

/// An element by a single index, which counts by columns.
#[function]
pub fn element(a: &Matrix3<f64>, index: usize) -> f64 {
    a[index]
}
