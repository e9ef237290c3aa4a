//! `udu` factors a covariance as Bierman's filters keep it; `bessemer::linear::ldl` factors without roots what need
//! not be positive definite.

use bessemer::prelude::*;

/// The variances of independent noises that make up a covariance; none if one is zero.
#[function]
pub fn variances(p: &Matrix3<f64>) -> Option<Vector3<f64>> {
    let factors = p.udu()?;
    Some(factors.d)
}

/// The covariance that the factors stand for.
#[function]
pub fn composed(p: &Matrix2<f64>) -> Matrix2<f64> {
    if let Some(factors) = p.udu() {
        factors.u * factors.d_matrix() * factors.u.transpose()
    } else {
        Matrix2::zeros()
    }
}

/// The gain of an update, P·Hᵀ·S⁻¹, by factors without roots; zero where S has none.
#[function]
pub fn gain(p: &Matrix3<f64>, h: &SMatrix<f64, 2, 3>, s: &Matrix2<f64>) -> SMatrix<f64, 3, 2> {
    match bessemer::linear::ldl(s) {
        Some(factors) => factors.solve(&(h * p)).transpose(),
        None => SMatrix::zeros(),
    }
}

/// Test for a covariance of full rank, and the determinant.
#[function]
pub fn full_rank(p: &Matrix3<f32>) -> (bool, f32) {
    let factors = bessemer::linear::ldl(p);
    (factors.is_some_and(|it| it.is_positive()), factors.map_or(0.0, |it| it.determinant()))
}
