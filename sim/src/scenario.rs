//! A flight before it is flown: the true aircraft, the software's settings, the ground's commands, the air, the
//! sensors, and failures.
//!
//! Plain data: a flight depends on nothing else, and the seed is part of it. Commands and failures are events of
//! `bessemer_sim`, and outages of a sensor are faults of it.

use crate::air::Air;
use crate::ground_station::Order;
use crate::plant::State;
use crate::sensors::{Senses, Sensor};
use bessemer_sim::{Events, Fault, FaultKind};
use models::trajectory::SetPoint;
use models::{Airframe, Mode, Parameters, Settings};
use nalgebra::Vector3;

/// Time on the ground before take-off, in which the estimator settles, s. Flights count from take-off.
pub const LEAD: f64 = 1.0;

/// A failure in flight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Failure {
    /// A motor stops.
    Motor(usize),
    /// A sensor sticks.
    Sensor(Sensor),
    /// A gain changes its sign.
    Gain(Gain),
}

/// An event of a flight.
#[derive(Clone, Debug, PartialEq)]
pub enum Event {
    /// A command of the ground station.
    Order(Order),
    /// A failure, which stays.
    Failure(Failure),
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
    /// Commands of the ground station and failures; times count from take-off.
    pub events: Events<Event>,
    /// Properties of the air.
    pub air: Air,
    /// Quality of the sensors.
    pub senses: Senses,
    /// Faults of the sensors from the start on, such as the times in which Vicon does not see the aircraft.
    pub faults: Vec<Fault>,
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
            events: [
                (-LEAD, Order::Hello),
                (-LEAD, Order::Mode(mode)),
                (-LEAD, Order::Fly(points.to_vec())),
                (0.0, Order::TakeOff),
                (landing, Order::Land),
            ]
            .map(|(time, order)| (time, Event::Order(order)))
            .into_iter()
            .collect(),
            air: Air { steady: Vector3::zeros(), gusts: 0.001, memory: 0.5 },
            senses: Senses::usual(),
            faults: Vec::new(),
            seed: 1,
        }
    }

    /// Adds a command of the ground station at a time, s.
    pub fn order(&mut self, time: f64, order: Order) {
        self.events.add(time, Event::Order(order));
    }

    /// Adds a failure at a time, s.
    pub fn fail(&mut self, time: f64, failure: Failure) {
        self.events.add(time, Event::Failure(failure));
    }

    /// Hides the aircraft from Vicon between two times, s.
    pub fn hide(&mut self, from: f64, until: f64) {
        self.faults.push(Sensor::Vicon.fault(FaultKind::Silent, from, until));
    }

    /// Returns the first failure and its time, s.
    pub fn failure(&self) -> Option<(f64, Failure)> {
        self.events.iter().find_map(|(time, event)| match event {
            Event::Failure(failure) => Some((*time, *failure)),
            Event::Order(_) => None,
        })
    }
}

impl Gain {
    /// Changes the sign of the gain.
    pub fn reverse(self, parameters: &mut Parameters) {
        let all = match self {
            Gain::Roll => &mut parameters.roll,
            Gain::Pitch => &mut parameters.pitch,
            Gain::Height => &mut parameters.height,
            Gain::Along => {
                parameters.x.p = -parameters.x.p;
                parameters.x.d = -parameters.x.d;
                return;
            }
        };
        (all.p, all.i, all.d) = (-all.p, -all.i, -all.d);
    }
}

/// Creates a setpoint.
pub fn point(time: f64, x: f64, y: f64, z: f64, yaw: f64) -> SetPoint {
    SetPoint { time, position: Vector3::new(x, y, z), yaw }
}
