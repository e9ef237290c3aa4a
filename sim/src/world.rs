//! The world around the onboard computer: aircraft, motors, air, sensors. It advances by one control period at a
//! time.
//!
//! Knows no clock, no link and no scenario: the caller provides the period and the failures.

use crate::air::{Air, Wind};
use crate::motors::Motors;
use crate::plant::{Body, Loads, State};
use crate::sensors::{Senses, Sensors, Stuck};
use crate::vehicle::Vehicle;
use models::Airframe;
use models::calibration::Readings;
use nalgebra::{SVector, Vector3};

/// Number of plant steps in a control period, since the motors' speeds change during a period.
const SUBSTEPS: usize = 2;

/// The simulated world.
#[derive(Clone, Debug)]
pub struct World {
    /// True state of the aircraft.
    pub state: State,
    /// Motors of the aircraft.
    pub motors: Motors,
    /// The air.
    pub wind: Wind,
    /// Sensors of the aircraft.
    pub sensors: Sensors,
    vehicle: Vehicle,
    body: Body,
    period: f64,
}

impl World {
    /// Creates a world with motors of time constant `lag`, s, and the aircraft in the state `start`, from a seed.
    pub fn new(airframe: &Airframe, lag: f64, start: State, period: f64, seed: u64) -> Self {
        let vehicle = Vehicle::new(airframe);
        Self {
            state: start,
            motors: Motors::new(lag),
            wind: Wind::new(Air::default(), seed),
            sensors: Sensors::new(&Senses::usual(), seed),
            body: Body { mass: vehicle.mass, inertia: vehicle.inertia },
            vehicle,
            period,
        }
    }

    /// Returns this world with other air and sensors.
    #[must_use]
    pub fn with(self, air: Air, senses: &Senses, seed: u64) -> Self {
        Self { wind: Wind::new(air, seed), sensors: Sensors::new(senses, seed), ..self }
    }

    /// Returns the readings of the sensors in the period `n`, which begins at `time`, s.
    pub fn sense(&mut self, n: usize, time: f64, stuck: Option<Stuck>) -> Readings {
        self.sensors.read(n, time, self.period, &self.state, stuck)
    }

    /// Advances one period with motor speed setpoints, rad/s. Returns the speed at which the aircraft hit the ground,
    /// m/s; 0 if it did not.
    pub fn advance(&mut self, speeds: &SVector<f64, 8>) -> f64 {
        let mut impact = 0.0;
        let force = self.wind.blow(self.period);
        for _ in 0..SUBSTEPS {
            let step = self.period / SUBSTEPS as f64;
            let squares = self.motors.turn(speeds, step);
            let (thrust, torque) = self.vehicle.loads(squares.as_slice());
            // On the ground the wind finds the aircraft in the lee, and its feet do not slide.
            let wind = if self.state.position.z > 0.0 { force } else { Vector3::zeros() };
            let next = self.state.after(&self.body, &Loads { thrust, torque, wind }, step);
            if self.state.position.z > 0.0 && next.position.z <= 0.0 {
                impact = -self.state.velocity.z;
            }
            self.state = next;
        }
        impact
    }
}
