//! `lu` factors a matrix once for several systems of equations; its result is a local variable.

use bessemer::prelude::*;

/// The solution of a system, refined once by its residual; `None` if the matrix is singular.
#[function]
pub fn refined(a: &Matrix3<f64>, b: &Vector3<f64>) -> Option<Vector3<f64>> {
    let lu = a.lu();
    let x = lu.solve(b)?;
    let residual = b - a * x;
    let correction = lu.solve(&residual)?;
    Some(x + correction)
}

/// The determinant and the inverse; zeros if there is none.
#[function]
pub fn both(a: &Matrix4<f32>) -> (f32, Matrix4<f32>) {
    let lu = a.lu();
    (lu.determinant(), lu.try_inverse().unwrap_or(Matrix4::zeros()))
}
