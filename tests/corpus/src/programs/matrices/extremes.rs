//! The largest and smallest elements, and where they are. A NaN hides what comes before it, as in nalgebra.

use bessemer::prelude::*;

/// The range of a matrix' elements.
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

/// A command within limits, part by part.
#[function]
pub fn within(command: &Vector3<f64>, low: &Vector3<f64>, high: &Vector3<f64>) -> Vector3<f64> {
    command.sup(low).inf(high)
}

/// The magnitudes.
#[function]
pub fn magnitudes(a: &Matrix2<f32>) -> Matrix2<f32> {
    a.abs()
}
