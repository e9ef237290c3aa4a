//! Where to lean: the loops along x and y (thesis, eqs. (3.16), (3.17)).
//!
//! Knows neither yaw nor thrust: under (2.11) the thrust points along (−sin θ2, sin θ1 cos θ2,
//! cos θ1 cos θ2) whatever the yaw, so that pitch alone acts along x, and roll alone along y.

use crate::parameters::Parameters;
use crate::signals::Target;
use bessemer::prelude::*;

/// Roll, pitch and yaw that take the aircraft to its target, rad.
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
    let roll = -parameters.y.respond(error.y, error_rate.y);
    let pitch = parameters.x.respond(error.x, error_rate.x);
    Vector3::new(roll, pitch, target.yaw)
}
