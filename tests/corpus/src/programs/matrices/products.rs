//! Products of matrices and vectors.

use bessemer::prelude::*;

/// Advances a linear system by one step.
#[function]
pub fn advanced(
    system: &Matrix2<f64>,
    input: &SMatrix<f64, 2, 1>,
    state: &Vector2<f64>,
    command: f64,
) -> Vector2<f64> {
    system * state + input * command
}

/// Propagated covariance: A·P·Aᵀ + Q.
#[function]
pub fn spread(a: &Matrix3<f64>, p: &Matrix3<f64>, q: &Matrix3<f64>) -> Matrix3<f64> {
    a * p * a.transpose() + q
}
