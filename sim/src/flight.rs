//! A pilot that flies a mission in closed loop, recorded step by step.
//!
//! Knows the pilot only through its trait, and does not judge the flight.

use crate::mission::Mission;
use crate::pilot::Pilot;
use crate::plant::{Body, Loads, State};
use crate::vehicle::Vehicle;
use crate::world::{advance, tick};
use bessemer_sim::{Input, Integrator, Stepper};
use models::{Command, Estimate, Parameters, Target};

/// One control period of a flight.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// Start of the period, s.
    pub time: f64,
    /// True state of the aircraft.
    pub state: State,
    /// Estimate of the pilot.
    pub estimate: Estimate,
    /// Target of the pilot.
    pub target: Target,
    /// Command of the pilot.
    pub command: Command,
    /// State of the pilot afterwards, as words: see [`Pilot::state`].
    pub memory: Vec<u64>,
}

/// A recorded flight.
#[derive(Clone, Debug, PartialEq)]
pub struct Flight {
    /// Every control period, in order.
    pub steps: Vec<Step>,
    /// Final state of the aircraft.
    pub end: State,
}

/// Flies a mission with a vehicle: one step of the pilot in each control period, during which its command is
/// constant.
pub fn fly(
    vehicle: &Vehicle,
    parameters: &Parameters,
    mission: &Mission,
    pilot: &mut impl Pilot,
) -> Flight {
    let period = parameters.period;
    let count = (mission.duration / period).round() as usize;
    let body = Body { mass: vehicle.mass, inertia: vehicle.inertia };

    let rest = Input { command: Loads::default(), disturbance: () };
    let start = mission.start.vector();
    let mut aircraft = Stepper::new(body, start, rest, tick(period), Integrator::default());
    let mut steps = Vec::with_capacity(count);
    for n in 0..count {
        let time = n as f64 * period;
        let state = State::from_vector(&aircraft.state);
        let estimate = seen(&state);
        let target = mission.target(time);
        let command = pilot.step(&estimate, &target);
        let memory = pilot.state();
        steps.push(Step { time, state, estimate, target, command, memory });

        let squares = command.motors.map(|motor| motor * parameters.mixer.square_per_command);
        let (thrust, torque) = vehicle.loads(squares.as_slice());
        let torque = torque + mission.twist(time);
        aircraft.input.command = Loads { thrust, torque, wind: mission.wind };
        advance(&mut aircraft);
    }
    Flight { steps, end: State::from_vector(&aircraft.state) }
}

/// Returns the estimate of a perfect estimator.
pub fn seen(state: &State) -> Estimate {
    Estimate {
        position: state.position,
        angles: state.angles,
        velocity: state.velocity,
        rates: state.rates,
    }
}
