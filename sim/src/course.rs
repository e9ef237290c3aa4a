//! The events of a flight as they happen: commands of the ground station, and failures.

use bessemer_sim::{Fault, FaultKind, Pending};
use models::Settings;

use crate::ground_station::GroundStation;
use crate::scenario::{Event, Failure, Scenario};

/// Things that the events of a scenario change, and the events that have not happened yet.
pub(crate) struct Course<'s> {
    pending: Pending<'s, Event>,
    /// The ground station, with the commands that it is to send.
    pub ground: GroundStation,
    /// Present settings of the software.
    pub settings: Settings,
    /// Faults of the sensors.
    pub faults: Vec<Fault>,
    /// Index of the stopped motor.
    pub dead: Option<usize>,
}

impl<'s> Course<'s> {
    /// Creates the course of a scenario before its first event.
    pub fn new(scenario: &'s Scenario) -> Self {
        Self {
            pending: scenario.events.pending(),
            ground: GroundStation::default(),
            settings: scenario.settings,
            faults: scenario.faults.clone(),
            dead: None,
        }
    }

    /// Lets the events up to a time, s, happen. Returns true if one changes the settings.
    pub fn happen(&mut self, time: f64) -> bool {
        let mut changed = false;
        for (at, event) in self.pending.due(time) {
            match event {
                Event::Order(order) => self.ground.order(order),
                Event::Failure(Failure::Motor(motor)) => self.dead = Some(*motor),
                Event::Failure(Failure::Sensor(sensor)) => {
                    self.faults.push(sensor.fault(FaultKind::Stuck, *at, f64::INFINITY));
                }
                Event::Failure(Failure::Gain(gain)) => {
                    gain.reverse(&mut self.settings.parameters);
                    changed = true;
                }
            }
        }
        changed
    }

    /// Returns the fault of a sensor at a time, s.
    pub fn fault(&self, sensor: &str, time: f64) -> Option<FaultKind> {
        Fault::at(&self.faults, sensor, time)
    }
}
