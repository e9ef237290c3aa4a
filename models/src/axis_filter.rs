//! Position, velocity and the accelerometer's bias along one axis: a Kalman filter of three states.
//!
//! No sensor is known here; a correction is any measurement that is linear in the state.

use crate::covariance::{corrected, diagonal, grown};
use bessemer::prelude::*;

/// Row of the position, m.
#[data]
const POSITION: usize = 0;

/// Row of the velocity, m/s.
#[data]
const VELOCITY: usize = 1;

/// Row of the accelerometer's bias, m/s².
#[data]
const BIAS: usize = 2;

/// One axis of the inertial frame.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AxisFilter {
    /// Position, m; velocity, m/s; bias of the acceleration, m/s².
    pub state: Vector3<f64>,
    /// Covariance of the errors of these, in this order; symmetric.
    pub covariance: Matrix3<f64>,
}

#[data]
impl AxisFilter {
    /// Returns a state at rest at 0, with standard deviations `place`, m, and `bias`, m/s².
    pub fn at_rest(place: f64, bias: f64) -> AxisFilter {
        let spread = Vector3::new(place * place, 0.01, bias * bias);
        AxisFilter { state: Vector3::zeros(), covariance: diagonal(&spread) }
    }

    /// Predicts one period, s, from a measured acceleration, m/s², with standard deviation `noise`, m/s², and bias
    /// drift `drift`, m/s² in a second.
    pub fn predict(&mut self, acceleration: f64, period: f64, noise: f64, drift: f64) {
        let real = acceleration - self.state[BIAS];
        self.state[POSITION] += period * (self.state[VELOCITY] + 0.5 * period * real);
        self.state[VELOCITY] += period * real;

        let half = -0.5 * period * period;
        let advance = Matrix3::new(1.0, period, half, 0.0, 1.0, -period, 0.0, 0.0, 1.0);
        let push = noise * period;
        let wander = drift * drift * period;
        let slip = 0.5 * push * period;
        let growth = Vector3::new(slip * slip, push * push, wander);
        self.covariance = grown(&self.covariance, &advance, &growth);
    }

    /// Inflates the covariance of position and velocity by (0.5 m)² and (0.5 m/s)², so that the gate accepts larger
    /// innovations.
    pub fn inflate(&mut self) {
        self.covariance[(POSITION, POSITION)] += 0.25;
        self.covariance[(VELOCITY, VELOCITY)] += 0.25;
    }

    /// Corrects the state by a measurement of `row` · state with the passed variance. The measurement is rejected, and
    /// nothing changes, if the innovation exceeds `gate` standard deviations or is not a number.
    pub fn correct(&mut self, row: &Vector3<f64>, measured: f64, variance: f64, gate: f64) -> bool {
        let innovation = measured - row.dot(&self.state);
        let spread = self.covariance * row;
        let expected = row.dot(&spread) + variance;
        // A certain state with a certain measurement leaves no correction; neither does a measurement of infinite variance.
        let learns = expected > 0.0 && expected.is_finite();
        let plausible = learns && innovation * innovation <= gate * gate * expected;
        if !plausible {
            return false;
        }
        let gain = spread / expected;
        self.state += gain * innovation;
        self.covariance = corrected(&self.covariance, row, &gain, variance);
        true
    }
}
