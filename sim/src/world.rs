//! The world around the onboard computer: aircraft, motors, air, sensors. It advances by one control period at a
//! time, as a plant of `bessemer_sim`.
//!
//! Knows no clock, no link and no scenario: the caller provides the period and the faults.

use crate::air::{Air, Wind};
use crate::motors::Motors;
use crate::plant::{Body, Loads, Rigid, State};
use crate::sensors::{Seen, Senses, Sensors};
use crate::vehicle::Vehicle;
use bessemer_sim::{FaultKind, Input, Integrator, Plant, Stepper, Tick};
use models::Airframe;
use models::calibration::Readings;
use nalgebra::{SVector, Vector3};
use std::num::NonZeroU64;

/// Number of plant steps in a control period, since the motors' speeds change during a period.
pub(crate) const SUBSTEPS: u32 = 2;

/// An aircraft with its motors. Its command are the setpoints of the motors' speeds, rad/s; its disturbance is the force of
/// the wind in the inertial frame, N.
#[derive(Clone, Debug)]
pub struct Multicopter {
    /// Motors of the aircraft.
    pub motors: Motors,
    vehicle: Vehicle,
    body: Rigid<f64>,
    /// Loads of the present interval.
    loads: Loads,
    /// Height, m, and vertical speed, m/s, at the start of the interval.
    start: [f64; 2],
    /// Speed of the last touch-down, m/s.
    impact: f64,
}

impl Multicopter {
    /// Creates an aircraft with motors at rest, of time constant `lag`, s.
    pub fn new(airframe: &Airframe, lag: f64) -> Self {
        let vehicle = Vehicle::new(airframe);
        let body = Body { mass: vehicle.mass, inertia: vehicle.inertia }.rigid();
        let (loads, start) = (Loads::default(), [0.0; 2]);
        Self { motors: Motors::new(lag), vehicle, body, loads, start, impact: 0.0 }
    }
}

impl Plant<12> for Multicopter {
    type Command = SVector<f64, 8>;
    type Disturbance = Vector3<f64>;

    fn derivative(
        &self,
        _: f64,
        state: &SVector<f64, 12>,
        _: &Input<SVector<f64, 8>, Vector3<f64>>,
    ) -> SVector<f64, 12> {
        State::from_vector(state).slope(&self.body, &self.loads)
    }

    fn begin(
        &mut self,
        _: f64,
        length: f64,
        state: &SVector<f64, 12>,
        input: &Input<SVector<f64, 8>, Vector3<f64>>,
    ) {
        let State { position, velocity, .. } = State::from_vector(state);
        let squares = self.motors.turn(&input.command, length);
        let (thrust, torque) = self.vehicle.loads(squares.as_slice());
        // On the ground the wind finds the aircraft in the lee, and its feet do not slide.
        let wind = if position.z > 0.0 { input.disturbance } else { Vector3::zeros() };
        self.loads = Loads { thrust, torque, wind };
        self.start = [position.z, velocity.z];
    }

    fn end(&mut self, _: f64, state: &mut SVector<f64, 12>) {
        let next = State::from_vector(state).above_floor();
        let [height, climb] = self.start;
        if height > 0.0 && next.position.z <= 0.0 {
            self.impact = -climb;
        }
        *state = next.vector();
    }
}

/// The simulated world.
#[derive(Clone)]
pub struct World {
    /// The aircraft.
    pub aircraft: Stepper<Multicopter, 12>,
    /// The air.
    pub wind: Wind,
    /// Sensors of the aircraft.
    pub sensors: Sensors,
    period: f64,
}

impl World {
    /// Creates a world with motors of time constant `lag`, s, and the aircraft in the state `start`, from a seed.
    pub fn new(airframe: &Airframe, lag: f64, start: State, period: f64, seed: u64) -> Self {
        let aircraft = Multicopter::new(airframe, lag);
        let rest = Input { command: SVector::zeros(), disturbance: Vector3::zeros() };
        let tick = tick(period / f64::from(SUBSTEPS));
        let integrator = Integrator::default();
        Self {
            aircraft: Stepper::new(aircraft, start.vector(), rest, tick, integrator),
            wind: Wind::new(Air::default(), seed),
            sensors: Sensors::new(&Senses::usual(), period, seed),
            period,
        }
    }

    /// Returns this world with other air and sensors.
    #[must_use]
    pub fn with(self, air: Air, senses: &Senses, seed: u64) -> Self {
        let sensors = Sensors::new(senses, self.period, seed);
        Self { wind: Wind::new(air, seed), sensors, ..self }
    }

    /// Returns the true state of the aircraft.
    pub fn state(&self) -> State {
        State::from_vector(&self.aircraft.state)
    }

    /// Moves the aircraft to another state.
    pub fn place(&mut self, state: &State) {
        self.aircraft.state = state.vector();
    }

    /// Returns the readings of the sensors in the period `n`; `fault` returns the present fault of a sensor by its name.
    pub fn sense(&mut self, n: u64, fault: impl Fn(&str) -> Option<FaultKind>) -> Readings {
        self.sensors.read(n, &Seen::of(&self.state()), fault)
    }

    /// Advances one period with motor speed setpoints, rad/s. Returns the speed at which the aircraft hit the ground,
    /// m/s; 0 if it did not.
    pub fn advance(&mut self, speeds: &SVector<f64, 8>) -> f64 {
        self.aircraft.input = Input { command: *speeds, disturbance: self.wind.blow(self.period) };
        self.aircraft.plant.impact = 0.0;
        for _ in 0..SUBSTEPS {
            advance(&mut self.aircraft);
        }
        self.aircraft.plant.impact
    }
}

/// Advances an aircraft by a tick. After a derivative that is not finite, each number of the state is NaN: such an
/// aircraft is outside of every envelope.
pub(crate) fn advance<P: Plant<12>>(aircraft: &mut Stepper<P, 12>) {
    if aircraft.advance(1).is_err() {
        aircraft.state.fill(f64::NAN);
    }
}

/// Returns the tick of a length, s, to a nanosecond.
pub(crate) fn tick(length: f64) -> Tick {
    NonZeroU64::new((length * 1e9).round() as u64).unwrap_or(NonZeroU64::MIN).into()
}
