//! The whole onboard software flying a scenario: plant, motors, air, sensors, link; written down period
//! by period.
//!
//! Knows the computer only through its trait, and passes no judgement.

use crate::air::Wind;
use crate::computer::Computer;
use crate::ground_station::GroundStation;
use crate::motors::Motors;
use crate::plant::{Body, Loads, State};
use crate::scenario::{LEAD, Scenario};
use crate::sensors::Sensors;
use crate::vehicle::Vehicle;
use models::{Inputs, Outputs};
use nalgebra::SVector;

/// Steps of the plant in a control period: the motors change within one.
const SUBSTEPS: usize = 2;

/// One control period, as it was flown.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    /// Its beginning, from take-off on, s.
    pub time: f64,
    /// Where the aircraft was.
    pub state: State,
    /// What the software got.
    pub inputs: Inputs,
    /// What it said.
    pub outputs: Outputs,
    /// How fast the motors turned at the end of it, rad/s.
    pub speeds: SVector<f64, 8>,
    /// How fast the aircraft hit the ground in it, m/s; 0 if it did not.
    pub impact: f64,
}

/// A flight as it was flown.
#[derive(Clone, Debug, PartialEq)]
pub struct Voyage {
    /// Every control period, in order.
    pub moments: Vec<Moment>,
    /// The records that came down: the period, and the values.
    pub records: Vec<(u32, Vec<f64>)>,
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

/// Flies a scenario and shows each period, with the computer as it is after it, until `seen` has seen
/// enough.
pub fn follow<C: Computer>(
    scenario: &Scenario,
    computer: &mut C,
    mut seen: impl FnMut(&Moment, &C) -> bool,
) -> Vec<(u32, Vec<f64>)> {
    let period = scenario.settings.parameters.period;
    let count = ((scenario.duration + LEAD) / period).round() as usize;
    let vehicle = Vehicle::new(&scenario.airframe);
    let body = Body { mass: vehicle.mass, inertia: vehicle.inertia };
    let mut wind = Wind::new(scenario.air, scenario.seed);
    let mut motors = Motors::new(scenario.lag);
    let mut sensors = Sensors::new(&scenario.senses, scenario.seed);
    let mut ground = GroundStation::new(&scenario.orders);
    let mut state = scenario.start;

    for n in 0..count {
        let time = n as f64 * period - LEAD;
        let readings = sensors.read(n, time, period, &state, scenario.stuck_at(time));
        let clock = 1_000_000 + (n as u64) * (1e6 * period).round() as u64;
        let inputs = Inputs { time: clock, readings, uplink: ground.send(time) };
        let outputs = computer.step(&scenario.settings_at(time), &inputs);
        ground.receive(&outputs.downlink);

        let (before, mut impact) = (state, 0.0);
        motors.dead = scenario.dead_at(time);
        let force = wind.blow(period);
        for _ in 0..SUBSTEPS {
            let step = period / SUBSTEPS as f64;
            let squares = motors.turn(&outputs.command.speeds, step);
            let (thrust, torque) = vehicle.loads(squares.as_slice());
            // On the ground the wind finds the aircraft in the lee, and its feet do not slide.
            let wind = if state.position.z > 0.0 { force } else { nalgebra::Vector3::zeros() };
            let next = state.after(&body, &Loads { thrust, torque, wind }, step);
            if state.position.z > 0.0 && next.position.z <= 0.0 {
                impact = -state.velocity.z;
            }
            state = next;
        }
        let moment = Moment { time, state: before, inputs, outputs, speeds: motors.speeds, impact };
        if !seen(&moment, computer) {
            break;
        }
    }
    ground.records
}
