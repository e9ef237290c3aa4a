//! `udu` factors a covariance as Bierman's filters keep it.

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
