//! Covariances of any number of errors, kept symmetric after each change, so that rounding does not make
//! them lose their sign.
//!
//! Knows no filter: what the errors are is the filter's business.

use bessemer::prelude::*;

/// The matrix with the given diagonal.
#[function]
pub fn diagonal<const N: usize>(values: &SVector<f64, N>) -> SMatrix<f64, N, N> {
    let mut all = SMatrix::zeros();
    for n in 0..N {
        all[(n, n)] = values[n];
    }
    all
}

/// The covariance after errors have grown as `advance` says, and by `growth`.
#[function]
pub fn grown<const N: usize>(
    covariance: &SMatrix<f64, N, N>,
    advance: &SMatrix<f64, N, N>,
    growth: &SMatrix<f64, N, N>,
) -> SMatrix<f64, N, N> {
    symmetric(&(advance * covariance * advance.transpose() + growth))
}

/// The covariance after a measurement of `row` · errors with the given variance was weighed by `gain`:
/// Joseph's form, (I − K h) P (I − K h)ᵀ + K r Kᵀ.
#[function]
pub fn corrected<const N: usize>(
    covariance: &SMatrix<f64, N, N>,
    row: &SVector<f64, N>,
    gain: &SVector<f64, N>,
    variance: f64,
) -> SMatrix<f64, N, N> {
    let kept = SMatrix::identity() - gain * row.transpose();
    let noise = gain * gain.transpose() * variance;
    symmetric(&(kept * covariance * kept.transpose() + noise))
}

/// The symmetric part.
#[function]
fn symmetric<const N: usize>(matrix: &SMatrix<f64, N, N>) -> SMatrix<f64, N, N> {
    (matrix + matrix.transpose()) * 0.5
}
