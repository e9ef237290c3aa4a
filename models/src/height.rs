//! Height control: commanded thrust from the height error (thesis, eq. (3.14)).
//!
//! The attitude is unknown here: the commanded thrust is that of a level aircraft.

use crate::airframe::GRAVITY;
use crate::parameters::Parameters;
use crate::signals::Target;
use bessemer::prelude::*;

/// Largest integral of the height error, m·s: at the Mambo's gain its whole weight, most of which a feed-forward takes over.
#[requirement("HLR-05")]
#[data]
const INTEGRAL_LIMIT: f64 = 14.0;

/// Holds the height, and takes off.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Height {
    /// Integral of the height error, m·s.
    pub integral: f64,
}

#[component]
impl Height {
    /// Advances one control period and returns the commanded thrust (thesis, eq. (3.14)), N.
    #[requirement("HLR-01", "HLR-02", "HLR-05")]
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
            let integral = self.integral + error * parameters.period;
            self.integral = integral.clamp(-INTEGRAL_LIMIT, INTEGRAL_LIMIT);
        }

        weight + parameters.mass * target.climb_acceleration + correction
    }
}
