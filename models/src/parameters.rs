//! The controller's parameters, and their values for the Mambo (thesis, table 3.1).
//!
//! Parameters never change in flight: nothing here is state.

use crate::airframe::Airframe;
use crate::expectation::Push;
use crate::mixer::Mixer;
use crate::signals::Command;
use bessemer::prelude::*;

/// Gains of a PID law.
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
    /// Returns the output of the PID law for an error, its integral over time and its rate.
    pub fn respond(&self, error: f64, integral: f64, error_rate: f64) -> f64 {
        self.p * error + self.i * integral + self.d * error_rate
    }
}

/// Gains of a PD law.
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
    /// Returns the output of the PD law for an error and its rate.
    pub fn respond(&self, error: f64, error_rate: f64) -> f64 {
        self.p * error + self.d * error_rate
    }
}

/// Selection of the control law.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Candidate {
    /// The thesis' cascade, corrected: [`crate::cascade`].
    #[default]
    Cascade,
    /// The thesis' cascade with the map from position to tilt as printed: [`crate::printed`].
    Printed,
    /// A geometric law: [`crate::geometric`].
    Geometric,
}

/// All parameters of the controller.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Parameters {
    /// Control period, s.
    pub period: f64,
    /// Mass of the aircraft, kg.
    pub mass: f64,
    /// Moments of inertia about the body axes, kg·m².
    pub inertia: Vector3<f64>,
    /// Selected control law.
    pub candidate: Candidate,
    /// Thrust of the take-off in excess of the weight, as a fraction of the weight.
    pub takeoff_gain: f64,
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
    /// Gains of the geometric law.
    pub geometric: Geometric,
    /// From thrust and torques to motors.
    pub mixer: Mixer,
}

/// Gains of the geometric law, normalised by mass and inertia.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Geometric {
    /// Position error to acceleration, 1/s², and its rate, 1/s.
    pub place: Damped,
    /// Attitude error to angular acceleration, 1/s², and its rate, 1/s.
    pub attitude: Damped,
}

#[data]
impl Parameters {
    /// Returns the accelerations that a command is to cause.
    pub fn push(&self, command: &Command) -> Push {
        let wrench = self.mixer.wrench(command);
        let turn = wrench.torque.component_div(&self.inertia);
        Push { force: wrench.thrust / self.mass, turn }
    }

    /// Returns the parameters of the Parrot Mambo at 200 Hz (thesis, tables 3.1 and A.1), with more damping of the
    /// position.
    pub fn mambo() -> Parameters {
        let mut all = Parameters::thesis();
        all.x.d = -0.24;
        all.y.d = -0.24;
        all
    }

    /// Returns the parameters of the Parrot Mambo at 200 Hz as in the thesis (tables 3.1 and A.1).
    #[requirement("HLR-01", "HLR-02", "HLR-03", "HLR-04", "HLR-12")]
    pub fn thesis() -> Parameters {
        let airframe = Airframe::mambo();
        Parameters {
            period: 0.005,
            mass: airframe.mass,
            inertia: airframe.inertia,
            candidate: Candidate::Cascade,
            takeoff_gain: 0.2,
            height: Gains { p: 1.5, i: 0.05, d: 0.3 },
            // Negative: the angles are passive, so a forward motion needs a negative pitch.
            x: Damped { p: -0.24, d: -0.1 },
            y: Damped { p: -0.24, d: -0.1 },
            roll: Gains { p: 0.01, i: 0.01, d: 0.0028 },
            pitch: Gains { p: 0.014, i: 0.01, d: 0.002 },
            yaw: Gains { p: 0.005, i: 0.0, d: 0.0012 },
            geometric: Geometric {
                place: Damped { p: 2.5, d: 2.5 },
                attitude: Damped { p: 150.0, d: 22.0 },
            },
            mixer: Mixer::new(&airframe, 13840.8, 500.0),
        }
    }

    /// Returns the parameters of the hexacopter at 200 Hz: the Mambo's gains scaled by mass and inertia, with a slower
    /// attitude loop.
    pub fn hexacopter() -> Parameters {
        let airframe = Airframe::hexacopter();
        Parameters {
            mass: airframe.mass,
            inertia: airframe.inertia,
            height: Gains { p: 16.0, i: 1.6, d: 7.0 },
            x: Damped { p: -0.2, d: -0.17 },
            y: Damped { p: -0.2, d: -0.17 },
            roll: Gains { p: 2.0, i: 0.4, d: 0.4 },
            pitch: Gains { p: 2.0, i: 0.4, d: 0.4 },
            yaw: Gains { p: 0.15, i: 0.0, d: 0.12 },
            mixer: Mixer::new(&airframe, 2000.0, 500.0),
            ..Parameters::mambo()
        }
    }
}
