//! Sums, parts and products that are added to a matrix: nalgebra's methods, as functions of the C.

use bessemer::prelude::*;

/// Deviation of a rotation from the identity: its trace minus 3, and the largest magnitude.
#[function]
pub fn off(turn: &Matrix3<f64>) -> Vector2<f64> {
    Vector2::new(turn.trace() - 3.0, turn.amax())
}

/// Adds the outer product of a measurement, as in recursive least squares.
#[function]
pub fn learn(information: &mut Matrix3<f64>, x: &Vector3<f64>, forgetting: f64) {
    information.ger(1.0, x, x, forgetting);
}

/// The weights scaled so that their sum is one.
#[function]
pub fn weights(raw: &Vector4<f32>) -> Vector4<f32> {
    raw / raw.sum()
}
