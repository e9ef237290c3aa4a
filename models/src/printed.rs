//! The closed loop with the thesis' map from position to tilt as printed (thesis, eqs. (3.16), (3.17)).
//!
//! One of the control laws of the controller. It shows that the printed law fails: its map rotates with yaw, but
//! under (2.11) the direction of the thrust does not. It diverges from a yaw of about ±20°. Everything else equals
//! the cascade.

use crate::airframe::Wrench;
use crate::attitude::Attitude;
use crate::geometry::{Orientation, wrapped};
use crate::height::Height;
use crate::parameters::Parameters;
use crate::signals::{Estimate, Target};
use bessemer::prelude::*;

/// The loops of height, roll, pitch and yaw.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Printed {
    /// The height loop.
    pub height: Height,
    /// The loops of roll, pitch and yaw.
    pub attitude: Attitude,
}

#[component]
impl Printed {
    /// Advances one control period and returns the commanded thrust and torques.
    #[entry(infallible)]
    pub fn step(
        &mut self,
        parameters: &Parameters,
        estimate: &Estimate,
        target: &Target,
    ) -> Wrench {
        let orientation = Orientation::of(&estimate.angles);
        let mut error = lean(parameters, target, estimate) - estimate.angles;
        error.z = wrapped(error.z);
        let wanted_rates = Vector3::new(0.0, 0.0, target.yaw_rate);
        let error_rate = wanted_rates - orientation.angle_rates(&estimate.rates);

        // The torques act on the body's axes directly: minus the PID output, without the axes of (2.16).
        let torque = -self.attitude.step(parameters, &error, &error_rate, target.grounded);
        let climb = estimate.velocity.z;
        let thrust = self.height.step(parameters, target, estimate.position.z, climb);
        Wrench { thrust, torque }
    }
}

/// Returns the roll, pitch and yaw that take the aircraft to its target, rad (thesis, eqs. (3.16), (3.17)). The gains
/// are in rad per metre and both negative, without which the law does not fly at any yaw.
#[function]
pub fn lean(parameters: &Parameters, target: &Target, estimate: &Estimate) -> Vector3<f64> {
    let error = target.position - estimate.position;
    let error_rate = target.velocity - estimate.velocity;
    let along = parameters.x.respond(error.x, error_rate.x);
    let across = parameters.y.respond(error.y, error_rate.y);
    let (sine, cosine) = target.yaw.sin_cos();
    let roll = along * sine - across * cosine;
    let pitch = along * cosine + across * sine;
    Vector3::new(roll, pitch, target.yaw)
}
