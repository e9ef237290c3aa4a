//! Vectors are nalgebra's; in the C they are arrays. Each operation has nalgebra's order, and so the same bits.

use bessemer::prelude::*;

/// Velocity after a step with drag, m/s.
#[function]
pub fn velocity(velocity: &Vector3<f64>, force: &Vector3<f64>, mass: f64, time: f64) -> Vector3<f64> {
    let acceleration = (force - velocity * 0.1) / mass;
    velocity + acceleration * time
}

/// The length of the component of `a` perpendicular to `b`, for a `b` of length 1.
#[function]
pub fn across(a: &Vector3<f64>, b: &Vector3<f64>) -> f64 {
    a.cross(b).norm()
}
