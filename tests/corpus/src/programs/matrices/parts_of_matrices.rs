//! Sums, parts and products that add to a matrix: nalgebra's methods, as functions of the C.

use bessemer::prelude::*;

/// Difference of a matrix from the identity: its trace less its size, and the largest magnitude.
#[function]
pub fn off(turn: &Matrix3<f64>) -> Vector2<f64> {
    Vector2::new(turn.trace() - 3.0, turn.amax())
}

/// Adds the outer product of a measurement, as recursive least squares do.
#[function]
pub fn learn(information: &mut Matrix3<f64>, x: &Vector3<f64>, forgetting: f64) {
    information.ger(1.0, x, x, forgetting);
}

/// Weights that sum to one.
#[function]
pub fn weights(raw: &Vector4<f32>) -> Vector4<f32> {
    raw / raw.sum()
}
