//! Roll, pitch, yaw and the gyroscope's biases: an extended Kalman filter of six states.
//!
//! The only sensor known here is the gyroscope; a correction is any measurement of one angle.

use crate::geometry::Orientation;
use bessemer::prelude::*;
use bessemer_estimation::{Status, Symmetric};

/// The aircraft's attitude.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AttitudeFilter {
    /// Roll, pitch and yaw, rad, then the gyroscope's biases about the body's x, y and z, rad/s.
    pub state: Vector6<f64>,
    /// Covariance of the errors of these, in this order.
    pub covariance: Symmetric<f64, 6>,
}

#[data]
impl AttitudeFilter {
    /// Returns a level attitude with standard deviations `angle`, rad, and `bias`, rad/s.
    pub fn level(angle: f64, bias: f64) -> AttitudeFilter {
        let mut variances = Vector6::zeros();
        for n in 0..3 {
            variances[n] = angle * angle;
            variances[n + 3] = bias * bias;
        }
        AttitudeFilter { state: Vector6::zeros(), covariance: Symmetric::diagonal(&variances) }
    }

    /// Returns roll, pitch and yaw, rad.
    pub fn angles(&self) -> Vector3<f64> {
        Vector3::new(self.state[0], self.state[1], self.state[2])
    }

    /// Returns measured rates without the gyroscope's biases, rad/s.
    pub fn rates(&self, measured: &Vector3<f64>) -> Vector3<f64> {
        measured - Vector3::new(self.state[3], self.state[4], self.state[5])
    }

    /// Predicts one period, s, from the measured rates, rad/s, with standard deviation `noise`, rad/s, and bias drift
    /// `drift`, rad/s in a second.
    #[requirement("HLR-26")]
    pub fn predict(&mut self, measured: &Vector3<f64>, period: f64, noise: f64, drift: f64) {
        self.state = predicted(&self.state, measured, period, &mut self.covariance);
        let turn = noise * period;
        let wander = drift * drift * period;
        for n in 0..3 {
            self.covariance.elements[(n, n)] += turn * turn;
            self.covariance.elements[(n + 3, n + 3)] += wander;
        }
    }

    /// Corrects the state by a measurement of the angle at an index: `innovation` is measured minus estimated.
    /// The measurement is rejected, and nothing changes, if the innovation exceeds `gate` standard deviations or is not
    /// a number. The `considered` parts of the state never change.
    #[requirement("HLR-20")]
    pub fn correct(
        &mut self,
        angle: usize,
        considered: &[bool; 6],
        innovation: f64,
        variance: f64,
        gate: f64,
    ) -> bool {
        let report = self.covariance.correct_considering(
            &mut self.state,
            considered,
            angle,
            innovation,
            variance,
            gate * gate,
        );
        report.status == Status::Corrected
    }
}

/// Returns the state after one period, s (thesis, eq. (2.17)).
#[function]
#[inline]
fn advanced(state: &Vector6<f64>, measured: &Vector3<f64>, period: f64) -> Vector6<f64> {
    let orientation = Orientation::of(&Vector3::new(state[0], state[1], state[2]));
    let rates = measured - Vector3::new(state[3], state[4], state[5]);
    let angle_rates = orientation.angle_rates(&rates);
    let mut next = *state;
    for n in 0..3 {
        next[n] += angle_rates[n] * period;
    }
    next
}

/// Returns the state after one period, s. The covariance becomes the covariance of its errors.
#[function(derivative(advanced, state))]
fn predicted(
    state: &Vector6<f64>,
    measured: &Vector3<f64>,
    period: f64,
    covariance: &mut Symmetric<f64, 6>,
) -> Vector6<f64> {
    let sin_cos_state_1 = state[1].sin_cos();
    let slope = -sin_cos_state_1.0;
    let sin_cos_state_2 = state[2].sin_cos();
    let slope_2 = -sin_cos_state_2.0;
    let rates_0 = measured[0] - state[3];
    let rates_1 = measured[1] - state[4];
    let rates_2 = measured[2] - state[5];
    let along = sin_cos_state_2.1 * rates_0 + sin_cos_state_2.0 * rates_1;
    let along_d2 = rates_0 * slope_2 + rates_1 * sin_cos_state_2.1;
    let along_d3 = -sin_cos_state_2.1;
    let along_d4 = -sin_cos_state_2.0;
    let across = sin_cos_state_2.0 * rates_0 - sin_cos_state_2.1 * rates_1;
    let across_d2 = rates_0 * sin_cos_state_2.1 - rates_1 * slope_2;
    let across_d3 = -sin_cos_state_2.0;
    let compared = sin_cos_state_1.1.abs();
    let divisor: f64;
    let divisor_d1: f64;
    if compared < 0.01 {
        let divisor_2 = (0.01).copysign(sin_cos_state_1.1);
        divisor = divisor_2;
        divisor_d1 = 0.0;
    } else {
        divisor = sin_cos_state_1.1;
        divisor_d1 = slope;
    }
    let roll_rate = -along / divisor;
    let roll_rate_d1 = -(roll_rate * divisor_d1) / divisor;
    let roll_rate_d2 = -along_d2 / divisor;
    let roll_rate_d3 = -along_d3 / divisor;
    let roll_rate_d4 = -along_d4 / divisor;
    let angle_rates_2 = sin_cos_state_1.0 * roll_rate - rates_2;
    let angle_rates_2_d1 = roll_rate * sin_cos_state_1.1 + sin_cos_state_1.0 * roll_rate_d1;
    let angle_rates_2_d2 = sin_cos_state_1.0 * roll_rate_d2;
    let angle_rates_2_d3 = sin_cos_state_1.0 * roll_rate_d3;
    let angle_rates_2_d4 = sin_cos_state_1.0 * roll_rate_d4;
    let next_0 = state[0] + roll_rate * period;
    let next_0_d1 = period * roll_rate_d1;
    let next_0_d2 = period * roll_rate_d2;
    let next_0_d3 = period * roll_rate_d3;
    let next_0_d4 = period * roll_rate_d4;
    let next_1 = state[1] + across * period;
    let next_1_d2 = period * across_d2;
    let next_1_d3 = period * across_d3;
    let next_1_d4 = period * sin_cos_state_2.1;
    let next_2 = state[2] + angle_rates_2 * period;
    let next_2_d1 = period * angle_rates_2_d1;
    let next_2_d2 = 1.0 + period * angle_rates_2_d2;
    let next_2_d3 = period * angle_rates_2_d3;
    let next_2_d4 = period * angle_rates_2_d4;
    let next = vector![next_0, next_1, next_2, state[3], state[4], state[5]];
    let row_0_0 = covariance.elements[(0, 0)]
        + next_0_d1 * covariance.elements[(1, 0)]
        + next_0_d2 * covariance.elements[(2, 0)]
        + next_0_d3 * covariance.elements[(3, 0)]
        + next_0_d4 * covariance.elements[(4, 0)];
    let row_0_1 = covariance.elements[(0, 1)]
        + next_0_d1 * covariance.elements[(1, 1)]
        + next_0_d2 * covariance.elements[(2, 1)]
        + next_0_d3 * covariance.elements[(3, 1)]
        + next_0_d4 * covariance.elements[(4, 1)];
    let row_0_2 = covariance.elements[(0, 2)]
        + next_0_d1 * covariance.elements[(1, 2)]
        + next_0_d2 * covariance.elements[(2, 2)]
        + next_0_d3 * covariance.elements[(3, 2)]
        + next_0_d4 * covariance.elements[(4, 2)];
    let row_1_1 = covariance.elements[(1, 1)]
        + next_1_d2 * covariance.elements[(2, 1)]
        + next_1_d3 * covariance.elements[(3, 1)]
        + next_1_d4 * covariance.elements[(4, 1)];
    let row_1_2 = covariance.elements[(1, 2)]
        + next_1_d2 * covariance.elements[(2, 2)]
        + next_1_d3 * covariance.elements[(3, 2)]
        + next_1_d4 * covariance.elements[(4, 2)];
    let row_2_1 = next_2_d2 * covariance.elements[(2, 1)]
        + next_2_d1 * covariance.elements[(1, 1)]
        + next_2_d3 * covariance.elements[(3, 1)]
        + next_2_d4 * covariance.elements[(4, 1)]
        + period * covariance.elements[(5, 1)];
    let row_2_2 = next_2_d2 * covariance.elements[(2, 2)]
        + next_2_d1 * covariance.elements[(1, 2)]
        + next_2_d3 * covariance.elements[(3, 2)]
        + next_2_d4 * covariance.elements[(4, 2)]
        + period * covariance.elements[(5, 2)];
    for k in 3..6 {
        let row_0 = covariance.elements[(0, k)]
            + next_0_d1 * covariance.elements[(1, k)]
            + next_0_d2 * covariance.elements[(2, k)]
            + next_0_d3 * covariance.elements[(3, k)]
            + next_0_d4 * covariance.elements[(4, k)];
        let row_1 = covariance.elements[(1, k)]
            + next_1_d2 * covariance.elements[(2, k)]
            + next_1_d3 * covariance.elements[(3, k)]
            + next_1_d4 * covariance.elements[(4, k)];
        let row_2 = next_2_d2 * covariance.elements[(2, k)]
            + next_2_d1 * covariance.elements[(1, k)]
            + next_2_d3 * covariance.elements[(3, k)]
            + next_2_d4 * covariance.elements[(4, k)]
            + period * covariance.elements[(5, k)];
        covariance.elements[(0, k)] = row_0;
        covariance.elements[(k, 0)] = row_0;
        covariance.elements[(1, k)] = row_1;
        covariance.elements[(k, 1)] = row_1;
        covariance.elements[(2, k)] = row_2;
        covariance.elements[(k, 2)] = row_2;
    }
    let block_0_0 = row_0_0
        + next_0_d1 * row_0_1
        + next_0_d2 * row_0_2
        + next_0_d3 * covariance.elements[(0, 3)]
        + next_0_d4 * covariance.elements[(0, 4)];
    let block_1_0 = row_0_1
        + next_1_d2 * row_0_2
        + next_1_d3 * covariance.elements[(0, 3)]
        + next_1_d4 * covariance.elements[(0, 4)];
    let block_1_1 = row_1_1
        + next_1_d2 * row_1_2
        + next_1_d3 * covariance.elements[(1, 3)]
        + next_1_d4 * covariance.elements[(1, 4)];
    let block_2_0 = next_2_d2 * row_0_2
        + next_2_d1 * row_0_1
        + next_2_d3 * covariance.elements[(0, 3)]
        + next_2_d4 * covariance.elements[(0, 4)]
        + period * covariance.elements[(0, 5)];
    let block_2_1 = next_2_d2 * row_1_2
        + next_2_d1 * row_1_1
        + next_2_d3 * covariance.elements[(1, 3)]
        + next_2_d4 * covariance.elements[(1, 4)]
        + period * covariance.elements[(1, 5)];
    let block_2_2 = next_2_d2 * row_2_2
        + next_2_d1 * row_2_1
        + next_2_d3 * covariance.elements[(2, 3)]
        + next_2_d4 * covariance.elements[(2, 4)]
        + period * covariance.elements[(2, 5)];
    covariance.elements[(0, 0)] = block_0_0;
    covariance.elements[(1, 0)] = block_1_0;
    covariance.elements[(0, 1)] = block_1_0;
    covariance.elements[(1, 1)] = block_1_1;
    covariance.elements[(2, 0)] = block_2_0;
    covariance.elements[(0, 2)] = block_2_0;
    covariance.elements[(2, 1)] = block_2_1;
    covariance.elements[(1, 2)] = block_2_1;
    covariance.elements[(2, 2)] = block_2_2;
    next
}
