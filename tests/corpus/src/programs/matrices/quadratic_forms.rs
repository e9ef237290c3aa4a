//! Products with a transpose, and products that add to a matrix.

use bessemer::prelude::*;

/// Propagated covariance: A·P·Aᵀ, added to Q.
#[function]
pub fn predicted(a: &Matrix3<f64>, p: &Matrix3<f64>, q: &Matrix3<f64>) -> Matrix3<f64> {
    let mut grown = *q;
    grown.quadform_tr(1.0, a, p, 1.0);
    grown
}

/// The information of measurements: Hᵀ·W·H.
#[function]
pub fn information(h: &SMatrix<f64, 4, 2>, w: &Matrix4<f64>) -> Matrix2<f64> {
    let mut sum = Matrix2::zeros();
    sum.quadform(1.0, w, h, 0.0);
    sum
}

/// The gradient of least squares: Hᵀ·r.
#[function]
pub fn gradient(h: &SMatrix<f32, 4, 2>, residual: &Vector4<f32>) -> Vector2<f32> {
    let mut gradient = Vector2::zeros();
    gradient.gemv_tr(2.0, h, residual, 0.0);
    gradient
}
