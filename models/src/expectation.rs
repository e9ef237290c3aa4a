//! The expected readings of the inertial sensors, by what the motors were told: they stand in for them while they
//! are silent.
//!
//! Mass, inertia and propellers are known to within a tenth, and sensors have biases: so what was felt
//! beyond what the commands explain is remembered, and counted in. Knows nothing of attitude or place.

use bessemer::prelude::*;

/// How fast the motors follow their commands: share of the way in a period.
#[data]
const FOLLOW: f64 = 0.25;

/// Share by which the expected rates follow the gyroscope in each period.
#[data]
const TURN: f64 = 0.2;

/// The same for the angular acceleration that no command explains, 1/s, as a share of the force, m/s².
#[data]
const UNEXPLAINED_TURN: f64 = 0.1;

/// Share by which the force that no command explains follows the accelerometer in each period.
#[data]
const UNEXPLAINED_FORCE: f64 = 0.02;

/// What the motors are to do to the aircraft.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Push {
    /// Thrust over the mass, along the body's z, m/s².
    pub force: f64,
    /// Torques over the moments of inertia, about the body's axes, rad/s².
    pub turn: Vector3<f64>,
}

/// What is expected of the gyroscope and of the accelerometer.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Expectation {
    /// What the motors do by now.
    pub push: Push,
    /// Angular velocity, as the gyroscope would show it, rad/s.
    pub rates: Vector3<f64>,
    /// Angular acceleration that the commands do not explain, rad/s², per specific force, m/s²: the
    /// propellers differ, and push the harder.
    pub turn: Vector3<f64>,
    /// Specific force that the commands do not explain, m/s².
    pub force: Vector3<f64>,
}

#[component]
impl Expectation {
    /// One period under the last commands.
    #[entry(infallible)]
    pub fn step(&mut self, period: f64, told: &Push) {
        self.push.force += (told.force - self.push.force) * FOLLOW;
        self.push.turn += (told.turn - self.push.turn) * FOLLOW;
        self.rates += (self.push.turn + self.turn * self.push.force) * period;
    }

    /// What the gyroscope showed, rad/s.
    #[entry(infallible)]
    pub fn turned(&mut self, rates: &Vector3<f64>) {
        let missed = rates - self.rates;
        self.rates += missed * TURN;
        self.turn += missed * UNEXPLAINED_TURN;
    }

    /// What the accelerometer showed, m/s².
    #[entry(infallible)]
    pub fn felt(&mut self, force: &Vector3<f64>) {
        let missed = force - self.felt_force();
        self.force += missed * UNEXPLAINED_FORCE;
    }

    /// Specific force, as the accelerometer would show it, m/s².
    #[entry(infallible)]
    pub fn felt_force(&self) -> Vector3<f64> {
        Vector3::new(0.0, 0.0, self.push.force) + self.force
    }
}
