//! Prediction of the inertial sensors' readings from the motor commands, used while the sensors are silent.
//!
//! Mass, inertia and propellers are known to within 10 %, and sensors have biases. Measured accelerations that the
//! commands do not explain are therefore estimated and added. Attitude and position are unknown here.

use bessemer::prelude::*;

/// Response of the motors to a command: fraction of the difference per period.
#[data]
const MOTOR_RESPONSE: f64 = 0.25;

/// Gain by which the predicted rates follow the gyroscope in each period.
#[data]
const RATE_GAIN: f64 = 0.2;

/// Gain of the unexplained angular acceleration per specific force, 1/s.
#[data]
const UNEXPLAINED_TURN_GAIN: f64 = 0.1;

/// Gain by which the unexplained specific force follows the accelerometer in each period.
#[data]
const UNEXPLAINED_FORCE_GAIN: f64 = 0.02;

/// Accelerations that the motor commands are to cause.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Push {
    /// Thrust over the mass, along the body's z, m/s².
    pub force: f64,
    /// Torques over the moments of inertia, about the body's axes, rad/s².
    pub turn: Vector3<f64>,
}

/// Predictor of the gyroscope's and the accelerometer's readings.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Expectation {
    /// Accelerations caused by the motors now.
    pub push: Push,
    /// Predicted angular velocity, rad/s.
    pub rates: Vector3<f64>,
    /// Angular acceleration that the commands do not explain, rad/s², per specific force, m/s²: unequal propellers have
    /// an effect in proportion to their thrust.
    pub turn: Vector3<f64>,
    /// Specific force that the commands do not explain, m/s².
    pub force: Vector3<f64>,
}

#[component]
impl Expectation {
    /// Advances one period under the last commands.
    #[entry(infallible)]
    pub fn step(&mut self, period: f64, commanded: &Push) {
        self.push.force += (commanded.force - self.push.force) * MOTOR_RESPONSE;
        self.push.turn += (commanded.turn - self.push.turn) * MOTOR_RESPONSE;
        self.rates += (self.push.turn + self.turn * self.push.force) * period;
    }

    /// Corrects the prediction by the measured rates, rad/s.
    #[entry(infallible)]
    pub fn correct_rates(&mut self, rates: &Vector3<f64>) {
        let residual = rates - self.rates;
        self.rates += residual * RATE_GAIN;
        self.turn += residual * UNEXPLAINED_TURN_GAIN;
    }

    /// Corrects the prediction by the measured specific force, m/s².
    #[entry(infallible)]
    pub fn correct_force(&mut self, force: &Vector3<f64>) {
        let residual = force - self.predicted_force();
        self.force += residual * UNEXPLAINED_FORCE_GAIN;
    }

    /// Returns the predicted specific force, m/s².
    #[entry(infallible)]
    pub fn predicted_force(&self) -> Vector3<f64> {
        Vector3::new(0.0, 0.0, self.push.force) + self.force
    }
}
