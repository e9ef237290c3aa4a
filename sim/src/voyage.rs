//! The whole onboard software flying a scenario: plant, motors, air, sensors and link, recorded period by period.
//!
//! Knows the computer only through its trait, and does not judge the flight.

use crate::computer::Computer;
use crate::course::Course;
use crate::ground_station::Record;
use crate::plant::State;
use crate::scenario::{LEAD, Scenario};
use crate::world::World;
use models::{Inputs, Outputs};
use nalgebra::SVector;

/// One control period of a flight.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    /// Start of the period, relative to take-off, s.
    pub time: f64,
    /// True state of the aircraft.
    pub state: State,
    /// Inputs of the software.
    pub inputs: Inputs,
    /// Outputs of the software.
    pub outputs: Outputs,
    /// Speeds of the motors at the end of the period, rad/s.
    pub speeds: SVector<f64, 8>,
    /// Speed at which the aircraft hit the ground in the period, m/s; 0 if it did not.
    pub impact: f64,
}

/// A recorded flight.
#[derive(Clone, Debug, PartialEq)]
pub struct Voyage {
    /// Every control period, in order.
    pub moments: Vec<Moment>,
    /// Records received on the ground.
    pub records: Vec<Record>,
}

/// Flies a scenario.
pub fn fly(scenario: &Scenario, computer: &mut impl Computer) -> Voyage {
    let mut moments = Vec::new();
    let records = follow(scenario, computer, |moment, _| {
        moments.push(moment.clone());
        true
    });
    Voyage { moments, records }
}

/// Flies a scenario; calls `seen` with each period and the computer after it, until it returns true.
pub fn follow<C: Computer>(
    scenario: &Scenario,
    computer: &mut C,
    mut seen: impl FnMut(&Moment, &C) -> bool,
) -> Vec<Record> {
    let period = scenario.settings.parameters.period;
    let count = ((scenario.duration + LEAD) / period).round() as usize;
    let mut world =
        World::new(&scenario.airframe, scenario.lag, scenario.start, period, scenario.seed).with(
            scenario.air,
            &scenario.senses,
            scenario.seed,
        );
    let mut course = Course::new(scenario);

    for n in 0..count {
        let time = n as f64 * period - LEAD;
        course.happen(time);
        world.aircraft.plant.motors.dead = course.dead;
        let readings = world.sense(n as u64, |sensor| course.fault(sensor, time));
        let clock = 1_000_000 + (n as u64) * (1e6 * period).round() as u64;
        let uplink = course.ground.send();
        let inputs = Inputs { time: clock, readings, uplink, ..Inputs::default() };
        let outputs = computer.step(&course.settings, &inputs);
        course.ground.receive(&outputs.downlink);

        let state = world.state();
        let impact = world.advance(&outputs.command.speeds);
        let speeds = world.aircraft.plant.motors.speeds;
        let moment = Moment { time, state, inputs, outputs, speeds, impact };
        if !seen(&moment, computer) {
            break;
        }
    }
    course.ground.records
}
