//! A flight before it is flown: the true aircraft, the software's settings, the ground's commands, the air, the
//! sensors, and failures.
//!
//! Plain data: a flight depends on nothing else, and the seed is part of it.

use crate::air::Air;
use crate::ground_station::Order;
use crate::plant::State;
use crate::sensors::{Senses, Stuck};
use models::trajectory::SetPoint;
use models::{Airframe, Mode, Settings};
use nalgebra::Vector3;

/// Time on the ground before take-off, in which the estimator settles, s. Flights count from take-off.
pub const LEAD: f64 = 1.0;

/// A failure in flight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Failure {
    /// A motor stops.
    Motor(usize),
    /// A sensor sticks.
    Sensor(Stuck),
    /// A gain changes its sign.
    Gain(Gain),
}

/// A gain whose sign can change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gain {
    /// All three gains of roll.
    Roll,
    /// All three gains of pitch.
    Pitch,
    /// All three gains of height.
    Height,
    /// The gains from the position error along x to the tilt.
    Along,
}

/// Everything on which a flight depends.
#[derive(Clone, Debug, PartialEq)]
pub struct Scenario {
    /// Duration from take-off on, s.
    pub duration: f64,
    /// The software's settings.
    pub settings: Settings,
    /// The true airframe.
    pub airframe: Airframe,
    /// Time constant of the motors, s.
    pub lag: f64,
    /// Initial state.
    pub start: State,
    /// Commands of the ground station, in order of time.
    pub orders: Vec<(f64, Order)>,
    /// Properties of the air.
    pub air: Air,
    /// Quality of the sensors.
    pub senses: Senses,
    /// Failure and its time, s.
    pub failure: Option<(f64, Failure)>,
    /// Seed of all randomness.
    pub seed: u64,
}

impl Scenario {
    /// A flight of the Mambo along setpoints, which lands `landing` seconds after take-off.
    pub fn mambo(points: &[SetPoint], landing: f64, mode: Mode) -> Self {
        let height = points.last().map_or(0.0, |point| point.position.z);
        Self {
            duration: landing + height / 0.25 + 4.0,
            settings: Settings::mambo(),
            airframe: Airframe::mambo(),
            lag: 0.015,
            start: State {
                position: Vector3::new(0.1, -0.1, 0.0),
                angles: Vector3::new(0.01, -0.01, 0.05),
                ..State::default()
            },
            orders: vec![
                (-LEAD, Order::Hello),
                (-LEAD, Order::Mode(mode)),
                (-LEAD, Order::Fly(points.to_vec())),
                (0.0, Order::TakeOff),
                (landing, Order::Land),
            ],
            air: Air { steady: Vector3::zeros(), gusts: 0.001, memory: 0.5 },
            senses: Senses::usual(),
            failure: None,
            seed: 1,
        }
    }

    /// Returns the settings at a time, s.
    pub fn settings_at(&self, time: f64) -> Settings {
        let mut settings = self.settings;
        if let Some((at, Failure::Gain(gain))) = self.failure
            && time >= at
        {
            let parameters = &mut settings.parameters;
            let all = match gain {
                Gain::Roll => &mut parameters.roll,
                Gain::Pitch => &mut parameters.pitch,
                Gain::Height => &mut parameters.height,
                Gain::Along => {
                    parameters.x.p = -parameters.x.p;
                    parameters.x.d = -parameters.x.d;
                    return settings;
                }
            };
            (all.p, all.i, all.d) = (-all.p, -all.i, -all.d);
        }
        settings
    }

    /// Returns the sensor that is stuck at a time, s.
    pub fn stuck_at(&self, time: f64) -> Option<Stuck> {
        match self.failure {
            Some((at, Failure::Sensor(sensor))) if time >= at => Some(sensor),
            _ => None,
        }
    }

    /// Returns the motor that has stopped by a time, s.
    pub fn dead_at(&self, time: f64) -> Option<usize> {
        match self.failure {
            Some((at, Failure::Motor(motor))) if time >= at => Some(motor),
            _ => None,
        }
    }
}

/// Creates a setpoint.
pub fn point(time: f64, x: f64, y: f64, z: f64, yaw: f64) -> SetPoint {
    SetPoint { time, position: Vector3::new(x, y, z), yaw }
}
