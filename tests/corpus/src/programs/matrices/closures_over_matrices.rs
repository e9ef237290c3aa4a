//! Closures over the elements of matrices: `map`, `zip_map`, `apply`, `fold` and the like become
//! loops by columns, as in nalgebra; `from_fn` and `map_with_location` pass the row and the column.

use bessemer::prelude::*;

/// Each element, but not beyond a limit.
#[function]
pub fn limited(a: &Matrix3<f64>, limit: f64) -> Matrix3<f64> {
    a.map(|x| if x > limit { limit } else { x })
}

/// A weighted mean of two images.
#[function]
pub fn blended(a: &Matrix3<f32>, b: &Matrix3<f32>, share: f32) -> Matrix3<f32> {
    a.zip_map(b, |x, y| x + (y - x) * share)
}

/// The larger of two, element by element; a NaN counts for nothing.
#[function]
pub fn larger(a: &Matrix2<f64>, b: &Matrix2<f64>) -> Matrix2<f64> {
    a.zip_map(b, f64::max)
}

/// Takes a step towards a goal, in each part at most so far.
#[function]
pub fn step(position: &mut Vector3<f64>, goal: &Vector3<f64>, most: f64) {
    position.zip_apply(goal, |x, y| {
        let way = y - *x;
        *x += if way > most { most } else { way };
    });
}

/// Rounds in place, and counts what was negative.
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

/// Fades what is far from the diagonal.
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

/// An element by one index, by columns.
#[function]
pub fn element(a: &Matrix3<f64>, index: usize) -> f64 {
    a[index]
}
