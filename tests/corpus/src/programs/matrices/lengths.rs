//! Norms, and vectors scaled to a length.

use bessemer::prelude::*;

/// The direction of a vector; `None` if it is too short.
#[function]
pub fn direction(v: &Vector3<f64>) -> Option<Vector3<f64>> {
    v.try_normalize(1e-9)
}

/// An acceleration limited to the motors' maximum.
#[function]
pub fn feasible(acceleration: &Vector3<f32>, most: f32) -> Vector3<f32> {
    acceleration.cap_magnitude(most)
}

/// The midpoint of two positions, and their distance.
#[function]
pub fn between(a: &Vector2<f64>, b: &Vector2<f64>) -> (Vector2<f64>, f64) {
    (a.lerp(b, 0.5), a.metric_distance(b))
}

/// Returns true if a matrix rotates without stretching.
#[function]
pub fn turns(a: &Matrix3<f64>) -> bool {
    a.is_special_orthogonal(1e-9)
}
