//! What each motor contributes to thrust and torques (thesis, eqs. (3.9), (3.10)).
//!
//! Knows the limits of the motors, and nothing of why the thrust and the torques are wanted.

use crate::signals::Command;
use bessemer::prelude::*;

/// From thrust and torques to motors.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mixer {
    /// Squares of the motor speeds (rows) per thrust and roll, pitch and yaw torque (columns),
    /// rad²/s² per N and per N·m.
    pub allocation: Matrix4<f64>,
    /// Direction in which each motor turns, 1 or −1.
    pub spins: Vector4<f64>,
    /// Square of a motor's speed per unit of its command, rad²/s².
    pub square_per_command: f64,
    /// Largest command that a motor takes.
    pub largest_command: f64,
}

#[data]
impl Mixer {
    /// Motor commands for a thrust, N, and torques about the body axes, N·m.
    pub fn mix(&self, thrust: f64, torque: &Vector3<f64>) -> Command {
        let wanted = Vector4::new(thrust, torque.x, torque.y, torque.z);
        let mut motors = self.allocation * wanted / self.square_per_command;
        let mut speeds = Vector4::zeros();
        for n in 0..4 {
            motors[n] = motors[n].max(0.0).min(self.largest_command);
            speeds[n] = self.spins[n] * (motors[n] * self.square_per_command).sqrt();
        }
        Command { motors, speeds }
    }
}
