//! Sums, means and variances of matrices, of their rows and of their columns.

use bessemer::prelude::*;

/// The bias of each axis of a gyroscope from eight samples, and its variance.
#[function]
pub fn bias(samples: &SMatrix<f64, 3, 8>) -> (Vector3<f64>, Vector3<f64>) {
    (samples.column_mean(), samples.column_variance())
}

/// The mean of each column.
#[function]
pub fn means(a: &SMatrix<f32, 4, 2>) -> SMatrix<f32, 1, 2> {
    a.row_mean()
}

/// The variance of a window.
#[function]
pub fn spread(window: &Vector6<f64>) -> f64 {
    window.variance()
}

/// The sum of each row as a fraction of the total.
#[function]
pub fn shares(a: &Matrix3<f64>) -> Vector3<f64> {
    a.column_sum() / a.sum()
}
