//! Transposes that are read without a copy: as factors of products, next to other elements, and where the matrix
//! itself is written.

use bessemer::prelude::*;

/// Covariance and mean of two states.
#[data]
#[derive(Clone, Debug, PartialEq)]
pub struct Belief {
    /// The covariance.
    pub covariance: Matrix2<f64>,
    /// The mean.
    pub mean: Vector2<f64>,
}

/// Advances the covariance, made symmetric in place.
#[function]
pub fn advance(belief: &mut Belief, advance: &Matrix2<f64>) {
    belief.covariance = advance * belief.covariance * advance.transpose();
    belief.covariance = (belief.covariance + belief.covariance.transpose()) * 0.5;
    belief.mean = advance.transpose() * belief.mean;
}

/// The covariance after a measurement: it uses a column times a row.
#[function]
pub fn corrected(
    covariance: &Matrix3<f64>,
    gain: &Vector3<f64>,
    row: &Vector3<f64>,
    variance: f64,
) -> Matrix3<f64> {
    let kept = Matrix3::identity() - gain * row.transpose();
    kept * covariance * kept.transpose() + gain * gain.transpose() * variance
}

/// Double transposes, a transposed rectangular matrix, and its products.
#[function]
pub fn oblongs(a: &SMatrix<f32, 2, 3>, b: &SMatrix<f32, 3, 2>) -> (Matrix3<f32>, Matrix2<f32>, SMatrix<f32, 3, 2>) {
    let both = a.transpose() * b.transpose();
    let sum = a.transpose() - b.component_mul(&a.transpose());
    (both, a * a.transpose() + (b.transpose() * b) * 2.0, sum)
}

/// A row of sums, and a row next to its column.
#[function]
pub fn lines(a: &Vector4<f64>, b: &SMatrix<f64, 1, 4>) -> (SMatrix<f64, 1, 4>, Vector4<f64>, f64) {
    let across = a.transpose() + b;
    let down = -(a * 3.0 - b.transpose());
    (across, down, (across * down)[(0, 0)])
}

/// A larger matrix, with kernels for products with a transpose on either side.
#[function]
pub fn large(a: &SMatrix<f64, 5, 4>, b: &SMatrix<f64, 5, 6>) -> (SMatrix<f64, 4, 6>, SMatrix<f64, 5, 5>) {
    (a.transpose() * b, b * b.transpose() - a * a.transpose())
}
