//! What goes into a control period, and what comes out of it.
//!
//! Plain data only: nothing here knows who fills it in, or who acts on it.

use bessemer::prelude::*;

/// What the estimator knows of the aircraft (thesis, eq. (2.18), with the velocity in the body
/// frame, where the optical flow measures it).
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sensed {
    /// Position in the inertial frame, z upwards, m.
    pub position: Vector3<f64>,
    /// Euler angles: roll, pitch, yaw, rad.
    pub angles: Vector3<f64>,
    /// Velocity in the body frame, m/s.
    pub velocity: Vector3<f64>,
    /// Angular velocity in the body frame, rad/s.
    pub rates: Vector3<f64>,
}

/// Where the aircraft is wanted, and in which part of the flight it is.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Target {
    /// Position in the inertial frame, m.
    pub position: Vector3<f64>,
    /// Velocity in the inertial frame, m/s.
    pub velocity: Vector3<f64>,
    /// Vertical acceleration, m/s².
    pub climb_acceleration: f64,
    /// Yaw, rad.
    pub yaw: f64,
    /// Rate of yaw, rad/s.
    pub yaw_rate: f64,
    /// Set while the aircraft takes off: it then climbs without minding its height.
    pub take_off: bool,
    /// Set while the aircraft lands: it then stops its motors on touch-down.
    pub land: bool,
}

/// What the motors are told.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Command {
    /// Command to each motor, 0 to the largest command.
    pub motors: Vector4<f64>,
    /// Speed that each motor is to take, with the sign of its rotation, rad/s.
    pub speeds: Vector4<f64>,
}
