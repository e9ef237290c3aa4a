//! The largest and smallest elements and their indices. As in nalgebra, the elements before a NaN do not count.

use bessemer::prelude::*;

/// The difference of the largest and the smallest element.
#[function]
pub fn range(a: &SMatrix<f64, 2, 3>) -> f64 {
    a.max() - a.min()
}

/// The index of the strongest of five motors, and its speed.
#[function]
pub fn strongest(speeds: &Vector5<f32>) -> (usize, f32) {
    speeds.argmax()
}

/// The axis with the largest error.
#[function]
pub fn worst(error: &Vector3<f64>) -> usize {
    error.iamax()
}

/// A command limited in each component.
#[function]
pub fn within(command: &Vector3<f64>, low: &Vector3<f64>, high: &Vector3<f64>) -> Vector3<f64> {
    command.sup(low).inf(high)
}

/// The magnitudes.
#[function]
pub fn magnitudes(a: &Matrix2<f32>) -> Matrix2<f32> {
    a.abs()
}
