//! The aircraft's motion (thesis, eqs. (2.17)–(2.29), (2.49)), for any number of motors.
//!
//! On board it predicts; on the ground the identification fits it. It knows motor speeds, not their source, and no
//! contact with the ground.

use crate::airframe::{Airframe, GRAVITY, MAX_MOTORS, Wrench};
use crate::geometry::Orientation;
use bessemer::prelude::*;

/// Position, attitude and their rates (thesis, eq. (2.18)).
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motion {
    /// Position in the inertial frame, z upwards, m.
    pub position: Vector3<f64>,
    /// Euler angles: roll, pitch, yaw, rad.
    pub angles: Vector3<f64>,
    /// Velocity in the inertial frame, m/s.
    pub velocity: Vector3<f64>,
    /// Angular velocity in the body frame, rad/s.
    pub rates: Vector3<f64>,
}

#[data]
impl Motion {
    /// Returns this motion plus `time` times a rate of change.
    pub fn plus(&self, slope: &Motion, time: f64) -> Motion {
        Motion {
            position: self.position + slope.position * time,
            angles: self.angles + slope.angles * time,
            velocity: self.velocity + slope.velocity * time,
            rates: self.rates + slope.rates * time,
        }
    }

    /// Returns the rate of change under the motors' wrench (thesis, eqs. (2.17), (2.23), (2.24), (2.28)).
    pub fn slope(&self, airframe: &Airframe, wrench: &Wrench) -> Motion {
        let orientation = Orientation::of(&self.angles);
        let push = orientation.thrust_direction() * (wrench.thrust / airframe.mass);
        let momentum = airframe.inertia.component_mul(&self.rates);
        let turn = wrench.torque - self.rates.cross(&momentum);
        Motion {
            position: self.velocity,
            angles: orientation.angle_rates(&self.rates),
            velocity: push - Vector3::new(0.0, 0.0, GRAVITY),
            rates: turn.component_div(&airframe.inertia),
        }
    }

    /// Returns the motion after `period` seconds of a constant wrench: one step of fourth-order Runge–Kutta.
    pub fn after(&self, airframe: &Airframe, wrench: &Wrench, period: f64) -> Motion {
        let first = self.slope(airframe, wrench);
        let second = self.plus(&first, period / 2.0).slope(airframe, wrench);
        let third = self.plus(&second, period / 2.0).slope(airframe, wrench);
        let fourth = self.plus(&third, period).slope(airframe, wrench);
        let middle = second.plus(&third, 1.0);
        let outer = first.plus(&fourth, 1.0);
        self.plus(&outer.plus(&middle, 2.0), period / 6.0)
    }
}

#[data]
impl Airframe {
    /// Returns thrust and torques of the motors at their speeds, rad/s, of either sign (thesis, eq. (2.49)).
    pub fn wrench(&self, speeds: &SVector<f64, MAX_MOTORS>) -> Wrench {
        let mut squares = SVector::zeros();
        for n in 0..MAX_MOTORS {
            squares[n] = speeds[n] * speeds[n];
        }
        let effect = self.effectiveness() * squares;
        Wrench { thrust: effect[0], torque: Vector3::new(effect[1], effect[2], effect[3]) }
    }
}

/// The simulated aircraft, in virtual time or ahead of real time.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Plant {
    /// Present motion.
    pub motion: Motion,
}

#[component]
impl Plant {
    /// Advances one period, s, at the passed motor speeds, rad/s, and returns the motion.
    #[entry(infallible)]
    pub fn step(
        &mut self,
        airframe: &Airframe,
        speeds: &SVector<f64, MAX_MOTORS>,
        period: f64,
    ) -> Motion {
        let wrench = airframe.wrench(speeds);
        self.motion = self.motion.after(airframe, &wrench, period);
        self.motion
    }
}
