//! Roll, pitch, yaw and the gyroscope's biases: an extended Kalman filter of six states.
//!
//! The only sensor known here is the gyroscope; a correction is any measurement of one angle.

use crate::covariance::{corrected, grown};
use crate::geometry::Orientation;
use bessemer::prelude::*;

/// Row and column of roll.
#[data]
const ROLL: usize = 0;

/// Row and column of pitch.
#[data]
const PITCH: usize = 1;

/// Row and column of yaw.
#[data]
const YAW: usize = 2;

/// Row and column of the gyroscope's bias about the body's x.
#[data]
const BIAS_X: usize = 3;

/// Row and column of the gyroscope's bias about the body's y.
#[data]
const BIAS_Y: usize = 4;

/// Row and column of the gyroscope's bias about the body's z.
#[data]
const BIAS_Z: usize = 5;

/// The aircraft's attitude.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AttitudeFilter {
    /// Roll, pitch and yaw, rad.
    pub angles: Vector3<f64>,
    /// Biases of the gyroscope, rad/s.
    pub bias: Vector3<f64>,
    /// Covariance of the errors: roll, pitch, yaw (rad²), then the biases about the body's x, y, z
    /// (rad²/s²); symmetric.
    pub covariance: Matrix6<f64>,
}

#[data]
impl AttitudeFilter {
    /// Returns a level attitude with standard deviations `angle`, rad, and `bias`, rad/s.
    pub fn level(angle: f64, bias: f64) -> AttitudeFilter {
        let mut covariance = Matrix6::zeros();
        for n in 0..3 {
            covariance[(n, n)] = angle * angle;
            covariance[(n + 3, n + 3)] = bias * bias;
        }
        AttitudeFilter { angles: Vector3::zeros(), bias: Vector3::zeros(), covariance }
    }

    /// Predicts one period, s, from the measured rates, rad/s, with standard deviation `noise`, rad/s, and bias drift
    /// `drift`, rad/s in a second.
    pub fn predict(&mut self, measured: &Vector3<f64>, period: f64, noise: f64, drift: f64) {
        let orientation = Orientation::of(&self.angles);
        let rates = measured - self.bias;
        let advance = advance(&orientation, &rates, period);
        self.angles += orientation.angle_rates(&rates) * period;

        let turn = noise * period;
        let wander = drift * drift * period;
        let mut growth = Vector6::zeros();
        for n in 0..3 {
            growth[n] = turn * turn;
            growth[n + 3] = wander;
        }
        self.covariance = grown(&self.covariance, &advance, &growth);
    }

    /// Corrects the state by a measurement of the angle that `row` selects: `innovation` is measured minus estimated.
    /// The measurement is rejected, and nothing changes, if the innovation exceeds `gate` standard deviations or is not
    /// a number.
    ///
    /// `moves` has a 1 for each part of the state that it may change, and 0 elsewhere: Joseph's form holds
    /// for any gain.
    pub fn correct(
        &mut self,
        row: &Vector6<f64>,
        moves: &Vector6<f64>,
        innovation: f64,
        variance: f64,
        gate: f64,
    ) -> bool {
        let spread = self.covariance * row;
        let expected = row.dot(&spread) + variance;
        // A certain state with a certain measurement leaves no correction; neither does a measurement of infinite variance.
        let learns = expected > 0.0 && expected.is_finite();
        let plausible = learns && innovation * innovation <= gate * gate * expected;
        if !plausible {
            return false;
        }
        let gain = spread.component_mul(moves) / expected;
        for n in 0..3 {
            self.angles[n] += gain[n] * innovation;
            self.bias[n] += gain[n + 3] * innovation;
        }
        self.covariance = corrected(&self.covariance, row, &gain, variance);
        true
    }
}

/// Returns the Jacobian of the state over one period: the derivative of (2.17).
#[function]
fn advance(orientation: &Orientation, rates: &Vector3<f64>, period: f64) -> Matrix6<f64> {
    let Orientation { s2, s3, c3, .. } = *orientation;
    let c2 = orientation.divisor();
    let along = c3 * rates.x + s3 * rates.y;
    let across = s3 * rates.x - c3 * rates.y;
    let lean = s2 / c2;

    let mut advance = Matrix6::identity();
    advance[(ROLL, PITCH)] = -period * along * lean / c2;
    advance[(ROLL, YAW)] = period * across / c2;
    advance[(PITCH, YAW)] = period * along;
    advance[(YAW, PITCH)] = -period * along / (c2 * c2);
    advance[(YAW, YAW)] += period * across * lean;

    advance[(ROLL, BIAS_X)] = period * c3 / c2;
    advance[(ROLL, BIAS_Y)] = period * s3 / c2;
    advance[(PITCH, BIAS_X)] = -period * s3;
    advance[(PITCH, BIAS_Y)] = period * c3;
    advance[(YAW, BIAS_X)] = period * c3 * lean;
    advance[(YAW, BIAS_Y)] = period * s3 * lean;
    advance[(YAW, BIAS_Z)] = period;
    advance
}
