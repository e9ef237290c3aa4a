//! `cholesky` returns `None` unless the matrix is positive definite.

use bessemer::prelude::*;

/// Normalised innovation squared, νᵀ·S⁻¹·ν; negative if S is not positive definite.
#[function]
pub fn surprise(s: &Matrix3<f64>, difference: &Vector3<f64>) -> f64 {
    match s.cholesky() {
        Some(factor) => difference.dot(&factor.solve(difference)),
        None => -1.0,
    }
}

/// The factor of a covariance after a measurement.
#[function]
pub fn updated(p: &Matrix2<f64>, x: &Vector2<f64>, weight: f64) -> Option<Matrix2<f64>> {
    let mut factor = p.cholesky()?;
    factor.rank_one_update(x, weight);
    Some(factor.l())
}
