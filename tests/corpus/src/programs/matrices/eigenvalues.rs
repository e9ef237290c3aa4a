//! Eigenvalues of symmetric matrices and singular values: the DSL's own routines with a bounded number of iterations.

use bessemer::prelude::*;

/// The axes of an error ellipsoid: half their lengths, the shortest first, and their directions.
#[function]
pub fn ellipsoid(covariance: &Matrix3<f64>) -> (Vector3<f64>, Matrix3<f64>) {
    let eigen = bessemer::linear::symmetric_eigen(covariance);
    (eigen.eigenvalues.map(|x| x.sqrt()), eigen.eigenvectors)
}

/// Condition of four measurements for two unknowns: the ratio of the singular values.
#[function]
pub fn condition(h: &SMatrix<f64, 4, 2>) -> f64 {
    bessemer::linear::svd(h).condition()
}

/// The command of two motors that comes closest to a moment about three axes, in least squares.
#[function]
pub fn allocated(effect: &SMatrix<f32, 3, 2>, moment: &Vector3<f32>) -> Vector2<f32> {
    bessemer::linear::svd(effect).solve(moment, 1e-6)
}

/// The smallest forces of five jets for two moments; if there are none, the nearest. Also the rank.
#[function]
pub fn shares(effect: &SMatrix<f64, 5, 2>) -> (SMatrix<f64, 2, 5>, u32) {
    let parts = bessemer::linear::svd(effect);
    (parts.pseudo_inverse(1e-6), parts.rank(1e-6) as u32)
}
