//! `udu` factors a covariance as in Bierman's filters; `bessemer::linear::ldl` factors matrices without square roots,
//! even if they are not positive definite.

use bessemer::prelude::*;

/// The variances of the independent noises of a covariance; `None` if one is zero.
#[function]
pub fn variances(p: &Matrix3<f64>) -> Option<Vector3<f64>> {
    let factors = p.udu()?;
    Some(factors.d)
}

/// The covariance that its factors multiply to.
#[function]
pub fn composed(p: &Matrix2<f64>) -> Matrix2<f64> {
    if let Some(factors) = p.udu() {
        factors.u * factors.d_matrix() * factors.u.transpose()
    } else {
        Matrix2::zeros()
    }
}

/// The gain of an update, P·Hᵀ·S⁻¹, by factors without roots; zero if S has none.
#[function]
pub fn gain(p: &Matrix3<f64>, h: &SMatrix<f64, 2, 3>, s: &Matrix2<f64>) -> SMatrix<f64, 3, 2> {
    match bessemer::linear::ldl(s) {
        Some(factors) => factors.solve(&(h * p)).transpose(),
        None => SMatrix::zeros(),
    }
}

/// Returns whether a covariance has full rank, and its determinant.
#[function]
pub fn full_rank(p: &Matrix3<f32>) -> (bool, f32) {
    let factors = bessemer::linear::ldl(p);
    (factors.is_some_and(|it| it.is_positive()), factors.map_or(0.0, |it| it.determinant()))
}
