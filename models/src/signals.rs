//! The inputs and outputs of a control period.
//!
//! Plain data only: producers and consumers are unknown here.

use crate::airframe::MAX_MOTORS;
use bessemer::prelude::*;

/// State estimate of the aircraft (thesis, eq. (2.18)).
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Estimate {
    /// Position in the inertial frame, z upwards, m.
    pub position: Vector3<f64>,
    /// Euler angles: roll, pitch, yaw of R = C1 C2 C3, passive: see [`crate::geometry`], rad.
    pub angles: Vector3<f64>,
    /// Velocity in the inertial frame, m/s.
    pub velocity: Vector3<f64>,
    /// Angular velocity about the body's x, y and z, by the right-hand rule, rad/s.
    pub rates: Vector3<f64>,
}

/// Target of the aircraft, and the phase of the flight.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Target {
    /// Position in the inertial frame, m.
    pub position: Vector3<f64>,
    /// Velocity in the inertial frame, m/s.
    pub velocity: Vector3<f64>,
    /// Acceleration along x and y, m/s².
    pub acceleration: Vector2<f64>,
    /// Vertical acceleration, m/s².
    pub climb_acceleration: f64,
    /// Yaw, rad.
    pub yaw: f64,
    /// Rate of yaw, rad/s.
    pub yaw_rate: f64,
    /// True during take-off: the height is not controlled.
    pub take_off: bool,
    /// True until the aircraft has left the ground: integrals are frozen.
    pub grounded: bool,
    /// True during landing: touch-down stops the motors.
    pub land: bool,
    /// True while a pilot flies: `lean` replaces the position.
    pub manual: bool,
    /// Roll and pitch setpoints of the pilot, rad.
    pub lean: Vector2<f64>,
}

#[data]
impl Target {
    /// Returns the target on the ground at the start.
    pub fn idle() -> Target {
        Target {
            position: Vector3::zeros(),
            velocity: Vector3::zeros(),
            acceleration: Vector2::zeros(),
            climb_acceleration: 0.0,
            yaw: 0.0,
            yaw_rate: 0.0,
            take_off: false,
            grounded: false,
            land: false,
            manual: false,
            lean: Vector2::zeros(),
        }
    }
}

/// Commands to the motors.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Command {
    /// Command to each motor, 0 to the largest command.
    pub motors: SVector<f64, MAX_MOTORS>,
    /// Speed setpoint of each motor, with the sign of its rotation, rad/s.
    pub speeds: SVector<f64, MAX_MOTORS>,
    /// Part of the speed that the closed loop requests, rad/s.
    pub closed_loop: SVector<f64, MAX_MOTORS>,
    /// Part of the speed that the feed-forward requests, rad/s.
    pub feed_forward: SVector<f64, MAX_MOTORS>,
}

#[data]
impl Command {
    /// Returns the command that stops all motors.
    pub fn still() -> Command {
        let zeros = SVector::zeros();
        Command { motors: zeros, speeds: zeros, closed_loop: zeros, feed_forward: zeros }
    }
}
