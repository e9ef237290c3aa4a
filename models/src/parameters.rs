//! What the controller can be tuned by, and the values that fly the Mambo (thesis, table 3.1).
//!
//! Parameters never change in flight: nothing here is state.

use crate::airframe::Airframe;
use crate::mixer::Mixer;
use bessemer::prelude::*;

/// Gains of an axis that also remembers its error.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Gains {
    /// Per unit of error.
    pub p: f64,
    /// Per unit of error and second.
    pub i: f64,
    /// Per unit of error and per second.
    pub d: f64,
}

#[data]
impl Gains {
    /// The PID law: what to do about an error, its integral over time and its rate.
    pub fn respond(&self, error: f64, integral: f64, error_rate: f64) -> f64 {
        self.p * error + self.i * integral + self.d * error_rate
    }
}

/// Gains of an axis without memory.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Damped {
    /// Per unit of error.
    pub p: f64,
    /// Per unit of error and per second.
    pub d: f64,
}

#[data]
impl Damped {
    /// The PD law: what to do about an error and its rate.
    pub fn respond(&self, error: f64, error_rate: f64) -> f64 {
        self.p * error + self.d * error_rate
    }
}

/// Everything that the controller can be tuned by.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Parameters {
    /// Control period, s.
    pub period: f64,
    /// Mass of the aircraft, kg.
    pub mass: f64,
    /// Thrust of the take-off in excess of the weight, as a fraction of the weight.
    pub takeoff_gain: f64,
    /// Height below which a landing aircraft counts as landed, m.
    pub touch_down: f64,
    /// Height error to thrust, N/m.
    pub height: Gains,
    /// Error along x to pitch, rad/m.
    pub x: Damped,
    /// Error along y to roll, rad/m.
    pub y: Damped,
    /// Roll error to torque, N·m/rad.
    pub roll: Gains,
    /// Pitch error to torque, N·m/rad.
    pub pitch: Gains,
    /// Yaw error to torque, N·m/rad.
    pub yaw: Gains,
    /// From thrust and torques to motors.
    pub mixer: Mixer,
}

#[data]
impl Parameters {
    /// The Parrot Mambo at 200 Hz (thesis, tables 3.1 and A.1).
    pub fn mambo() -> Parameters {
        let airframe = Airframe::mambo();
        Parameters {
            period: 0.005,
            mass: airframe.mass,
            takeoff_gain: 0.2,
            touch_down: 0.02,
            height: Gains { p: 1.5, i: 0.05, d: 0.3 },
            // Negative: to go forward is to lean the other way, since the angles are passive.
            x: Damped { p: -0.24, d: -0.1 },
            y: Damped { p: -0.24, d: -0.1 },
            roll: Gains { p: 0.01, i: 0.01, d: 0.0028 },
            pitch: Gains { p: 0.014, i: 0.01, d: 0.002 },
            yaw: Gains { p: 0.005, i: 0.0, d: 0.0012 },
            mixer: Mixer {
                allocation: airframe.allocation(),
                spins: airframe.spins,
                square_per_command: 13840.8,
                largest_command: 500.0,
            },
        }
    }
}
