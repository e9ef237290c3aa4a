//! One control period, from what is sensed to what the motors get (thesis, ch. 3).
//!
//! Composes the loops; every law is in the module named for it.

use crate::attitude::Attitude;
use crate::geometry::Orientation;
use crate::height::Height;
use crate::horizontal::lean;
use crate::parameters::Parameters;
use crate::signals::{Command, Sensed, Target};
use bessemer::prelude::*;

/// Flies the aircraft to its target.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Controller {
    /// The height loop.
    pub height: Height,
    /// The loops of roll, pitch and yaw.
    pub attitude: Attitude,
    /// Whether the landing aircraft has touched down.
    pub landed: bool,
}

#[component]
impl Controller {
    /// One control period: the command to each motor.
    #[entry(infallible)]
    pub fn step(&mut self, parameters: &Parameters, sensed: &Sensed, target: &Target) -> Command {
        let height = sensed.position.z;
        self.landed = target.land && (self.landed || height < parameters.touch_down);
        if self.landed {
            return Command { motors: Vector4::zeros(), speeds: Vector4::zeros() };
        }

        let orientation = Orientation::of(&sensed.angles);
        let velocity = orientation.rotation() * sensed.velocity;

        // How hard to push, and where to lean.
        let thrust = self.height.step(parameters, target, height, velocity.z);
        let wanted = lean(parameters, target, &sensed.position, &velocity);

        // The attitude loops act about the axes of roll, pitch and yaw; the motors, about the body's.
        let error = wanted - sensed.angles;
        let wanted_rates = Vector3::new(0.0, 0.0, target.yaw_rate);
        let error_rate = wanted_rates - orientation.angle_rates(&sensed.rates);
        let turn = self.attitude.step(parameters, &error, &error_rate);
        let torque = orientation.rate_matrix() * turn;

        parameters.mixer.mix(thrust, &torque)
    }
}
