//! Rows, columns and blocks of fixed size are values when read; a write to one changes the matrix.

use bessemer::prelude::*;

/// The component of the second axis along the first.
#[function]
pub fn along(axes: &Matrix3<f64>) -> f64 {
    axes.column(0).dot(&axes.column(1))
}

/// The attitude part of a covariance.
#[function]
pub fn attitude(covariance: &Matrix6<f64>) -> Matrix3<f64> {
    covariance.fixed_view::<3, 3>(3, 3).into_owned()
}

/// A state with a new velocity and half its position.
#[function]
pub fn moved(state: &SVector<f64, 6>, velocity: &Vector3<f64>) -> SVector<f64, 6> {
    let mut next = *state;
    next.fixed_rows_mut::<3>(3).copy_from(velocity);
    next.fixed_rows_mut::<3>(0).scale_mut(0.5);
    next
}
