//! `dot`, `tr_mul` and norms add in nalgebra's order, which for long vectors has eight partial sums.

use bessemer::prelude::*;

/// A filter over the last ten values.
#[function]
pub fn filtered(taps: &SMatrix<f64, 10, 1>, values: &SMatrix<f64, 10, 1>) -> f64 {
    taps.dot(values)
}

/// The information matrix of three measurements.
#[function]
pub fn information(jacobian: &SMatrix<f64, 3, 2>) -> Matrix2<f64> {
    jacobian.tr_mul(jacobian)
}

/// The sum of the squares.
#[function]
pub fn energy(v: &Vector4<f32>) -> f32 {
    v.norm_squared()
}
