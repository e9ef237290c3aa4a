//! `from` and `into` between matrices and arrays of their elements, by columns.

use bessemer::prelude::*;

/// An array from a driver as a vector for the filter.
#[function]
pub fn acceleration(raw: &[f32; 3], scale: f32) -> Vector3<f32> {
    Vector3::from(*raw) * scale
}

/// A vector from an array of computed elements.
#[function]
pub fn corner(x: f64, y: f64) -> Vector2<f64> {
    Vector2::from([x + y, x - y])
}

/// A vector with many elements.
#[function]
pub fn window(samples: &[f64; 20]) -> SVector<f64, 20> {
    SVector::from(*samples)
}

/// A matrix from an array of columns.
#[function]
pub fn columns(columns: &[[f64; 2]; 3]) -> Matrix2x3<f64> {
    Matrix2x3::from(*columns)
}

/// A matrix from columns that are written out, and a row vector.
#[function]
pub fn shear(factor: f32) -> (Matrix2<f32>, RowVector2<f32>) {
    (Matrix2::from([[1.0, 0.0], [factor, 1.0]]), RowVector2::from([factor, 2.0]))
}

/// A matrix from named columns, and one from a repeated column.
#[function]
pub fn beside(first: &[f64; 2], gain: f64) -> (Matrix2<f64>, Matrix2<f64>) {
    (Matrix2::from([*first, [gain; 2]]), Matrix2::from([[gain, 1.0], *first]))
}

/// Arrays for a message.
#[function]
pub fn packed(covariance: &Matrix3<f64>, rates: &Vector3<f32>) -> ([[f64; 3]; 3], [f32; 3]) {
    ((*covariance).into(), (*rates).into())
}

/// An array of a larger matrix, which is copied by a loop.
#[function]
pub fn far(covariance: &Matrix5<f32>) -> [[f32; 5]; 5] {
    let columns: [[f32; 5]; 5] = (*covariance).into();
    columns
}
