//! The inputs and outputs of a control period.
//!
//! Plain data only: nothing here knows who fills it in, or who acts on it.

use crate::airframe::MOST_MOTORS;
use bessemer::prelude::*;

/// What is known of the aircraft (thesis, eq. (2.18)).
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
    /// Set until the aircraft has left the ground: what it cannot turn or lift yet is no error to remember.
    pub grounded: bool,
    /// Set while the aircraft lands: it then stops its motors on touch-down.
    pub land: bool,
    /// Set while a pilot holds the sticks: `lean` then stands in for the place.
    pub manual: bool,
    /// Roll and pitch that the pilot asks for, rad.
    pub lean: Vector2<f64>,
}

#[data]
impl Target {
    /// On the ground where the flight began.
    pub fn idle() -> Target {
        Target {
            position: Vector3::zeros(),
            velocity: Vector3::zeros(),
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

/// What the motors are told.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Command {
    /// Command to each motor, 0 to the largest command.
    pub motors: SVector<f64, MOST_MOTORS>,
    /// Speed that each motor is to take, with the sign of its rotation, rad/s.
    pub speeds: SVector<f64, MOST_MOTORS>,
    /// What of the speed the closed loop asks for, rad/s.
    pub closed_loop: SVector<f64, MOST_MOTORS>,
    /// What of the speed the feed-forward asks for, rad/s.
    pub feed_forward: SVector<f64, MOST_MOTORS>,
}

#[data]
impl Command {
    /// All motors off.
    pub fn still() -> Command {
        let zeros = SVector::zeros();
        Command { motors: zeros, speeds: zeros, closed_loop: zeros, feed_forward: zeros }
    }
}
