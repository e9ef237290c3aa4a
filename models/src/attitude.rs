//! Attitude control: the loops of roll, pitch and yaw (thesis, eqs. (3.15), (3.18), (3.19)).
//!
//! The loops receive three angle errors; frames and motors are handled elsewhere.

use crate::parameters::Parameters;
use bessemer::prelude::*;

/// Largest integral of the error of an angle, rad·s: at the Mambo's gain as much torque as 0.5 rad.
#[requirement("HLR-05")]
#[data]
const INTEGRAL_LIMIT: f64 = 0.5;

/// Holds roll, pitch and yaw.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Attitude {
    /// Integrals of the errors of roll, pitch and yaw, rad·s.
    pub integral: Vector3<f64>,
}

#[component]
impl Attitude {
    /// Advances one control period and returns the torques about the axes of roll, pitch and yaw, N·m. On the ground
    /// the integrals are frozen.
    #[requirement("HLR-04", "HLR-05")]
    #[entry(infallible)]
    pub fn step(
        &mut self,
        parameters: &Parameters,
        error: &Vector3<f64>,
        error_rate: &Vector3<f64>,
        grounded: bool,
    ) -> Vector3<f64> {
        let integral = self.integral;
        if !grounded {
            for n in 0..3 {
                let integral = self.integral[n] + error[n] * parameters.period;
                self.integral[n] = integral.clamp(-INTEGRAL_LIMIT, INTEGRAL_LIMIT);
            }
        }

        Vector3::new(
            parameters.roll.respond(error.x, integral.x, error_rate.x),
            parameters.pitch.respond(error.y, integral.y, error_rate.y),
            parameters.yaw.respond(error.z, integral.z, error_rate.z),
        )
    }
}
