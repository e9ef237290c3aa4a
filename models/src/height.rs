//! How hard to push: the height loop (thesis, eq. (3.14)).
//!
//! Knows nothing of the aircraft's attitude: it commands thrust as if the aircraft were level.

use crate::airframe::GRAVITY;
use crate::parameters::Parameters;
use crate::signals::Target;
use bessemer::prelude::*;

/// Holds the height, and takes off.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Height {
    /// Integral of the height error, m·s.
    pub integral: f64,
}

#[component]
impl Height {
    /// One control period: the thrust to command (thesis, eq. (3.14)), N.
    #[entry(infallible)]
    pub fn step(
        &mut self,
        parameters: &Parameters,
        target: &Target,
        height: f64,
        climb: f64,
    ) -> f64 {
        let weight = parameters.mass * GRAVITY;
        if target.take_off {
            return weight + parameters.takeoff_gain * weight;
        }

        let error = target.position.z - height;
        let error_rate = target.velocity.z - climb;
        let correction = parameters.height.respond(error, self.integral, error_rate);
        if !target.grounded {
            self.integral += error * parameters.period;
        }

        weight + parameters.mass * target.climb_acceleration + correction
    }
}
