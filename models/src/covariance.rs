//! Covariances of any number of errors, kept symmetric after each change, so that rounding does not make
//! them lose their sign.
//!
//! No filter is known here: the meaning of the errors is up to the filter.

use bessemer::prelude::*;

/// Returns the diagonal matrix of the values.
#[function]
pub fn diagonal<const N: usize>(values: &SVector<f64, N>) -> SMatrix<f64, N, N> {
    let mut all = SMatrix::zeros();
    for n in 0..N {
        all[(n, n)] = values[n];
    }
    all
}

/// Propagates a covariance by the Jacobian `advance` and adds the variances `growth` of the process noise.
#[function]
pub fn grown<const N: usize>(
    covariance: &SMatrix<f64, N, N>,
    advance: &SMatrix<f64, N, N>,
    growth: &SVector<f64, N>,
) -> SMatrix<f64, N, N> {
    let mut moved = advance * covariance * advance.transpose();
    for n in 0..N {
        moved[(n, n)] += growth[n];
    }
    symmetric(&moved)
}

/// Corrects a covariance by a scalar measurement, in Joseph's form: (I − K h) P (I − K h)ᵀ + K r Kᵀ. `row` is h, `gain`
/// K, `variance` r.
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

/// Returns the symmetric part of a matrix.
#[function]
fn symmetric<const N: usize>(matrix: &SMatrix<f64, N, N>) -> SMatrix<f64, N, N> {
    (matrix + matrix.transpose()) * 0.5
}
