//! Horizontal control: commanded tilt from the position error along x and y (thesis, eqs. (3.16), (3.17)).
//!
//! Yaw and thrust are unknown here. Under (2.11) the thrust has the direction (−sin θ2, sin θ1 cos θ2, cos θ1 cos θ2)
//! at any yaw, so that only pitch acts along x, and only roll along y.

use crate::airframe::GRAVITY;
use crate::parameters::Parameters;
use crate::signals::Target;
use bessemer::prelude::*;

/// Returns the roll, pitch and yaw that take the aircraft to its target, rad.
#[requirement("HLR-03")]
#[function]
pub fn lean(
    parameters: &Parameters,
    target: &Target,
    position: &Vector3<f64>,
    velocity: &Vector3<f64>,
) -> Vector3<f64> {
    if target.manual {
        return Vector3::new(target.lean.x, target.lean.y, target.yaw);
    }
    let error = target.position - position;
    let error_rate = target.velocity - velocity;
    // The tilt of the planned acceleration, which the errors correct.
    let planned = target.acceleration / GRAVITY;
    let roll = planned.y - parameters.y.respond(error.y, error_rate.y);
    let pitch = -planned.x + parameters.x.respond(error.x, error_rate.x);
    Vector3::new(roll, pitch, target.yaw)
}
