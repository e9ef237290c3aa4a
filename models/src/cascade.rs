//! The thesis' closed loop, corrected so that it flies (thesis, ch. 3): position to tilt, tilt to torque.
//!
//! One of the control laws of the controller. It composes the loops; each law is in the module of its name.

use crate::airframe::Wrench;
use crate::attitude::Attitude;
use crate::geometry::{Orientation, wrapped};
use crate::height::Height;
use crate::horizontal::lean;
use crate::parameters::Parameters;
use crate::signals::{Estimate, Target};
use bessemer::prelude::*;

/// The loops of height, roll, pitch and yaw.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cascade {
    /// The height loop.
    pub height: Height,
    /// The loops of roll, pitch and yaw.
    pub attitude: Attitude,
}

#[component]
impl Cascade {
    /// Advances one control period and returns the commanded thrust and torques.
    #[requirement("HLR-04", "HLR-06", "HLR-07", "HLR-08")]
    #[entry(infallible)]
    pub fn step(
        &mut self,
        parameters: &Parameters,
        estimate: &Estimate,
        target: &Target,
    ) -> Wrench {
        let orientation = Orientation::of(&estimate.angles);

        // Commanded thrust and tilt.
        let climb = estimate.velocity.z;
        let thrust = self.height.step(parameters, target, estimate.position.z, climb);
        let wanted = lean(parameters, target, &estimate.position, &estimate.velocity);

        // The attitude loops act about the axes of roll, pitch and yaw; the motors, about the body's.
        let mut error = wanted - estimate.angles;
        error.z = wrapped(error.z);
        let wanted_rates = Vector3::new(0.0, 0.0, target.yaw_rate);
        let error_rate = wanted_rates - orientation.angle_rates(&estimate.rates);
        let turn = self.attitude.step(parameters, &error, &error_rate, target.grounded);
        let torque = orientation.rate_matrix() * turn;

        Wrench { thrust, torque }
    }
}
