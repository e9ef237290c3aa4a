//! An extended Kalman filter of twelve states: position, velocity, attitude and the bias of the gyro.
//!
//! The generator differentiates the prediction, and writes how it changes the covariance: only elements of the Jacobian that are neither
//! zero nor one are computed. `bessemer-estimation` corrects by six numbers at once, and rejects a measurement that is far from the estimate.

use bessemer::prelude::*;
use bessemer_estimation::{Correction, Symmetric};

/// Acceleration of gravity, m/s².
const GRAVITY: f64 = 9.81;

/// Surprise above which a measurement of six numbers is rejected: one in a billion.
const GATE: f64 = 52.0;

/// An inertial measurement.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inertial {
    /// Rate of the body, rad/s.
    pub rate: Vector3<f64>,
    /// Specific force in the body's frame, m/s².
    pub force: Vector3<f64>,
}

/// The state after one period, s: position and velocity, north, east and down; roll, pitch and yaw, rad; bias, rad/s.
#[function]
pub fn advanced(state: &SVector<f64, 12>, inertial: &Inertial, period: f64) -> SVector<f64, 12> {
    let (sin_roll, cos_roll) = state[6].sin_cos();
    let (sin_pitch, cos_pitch) = state[7].sin_cos();
    let (sin_yaw, cos_yaw) = state[8].sin_cos();
    let force = inertial.force;

    // The force in the plane of the ground, towards the heading and to its right, and down.
    let lift = sin_roll * force[1] + cos_roll * force[2];
    let ahead = cos_pitch * force[0] + sin_pitch * lift;
    let right = cos_roll * force[1] - sin_roll * force[2];
    let down = cos_pitch * lift - sin_pitch * force[0];
    let acceleration = Vector3::new(
        cos_yaw * ahead - sin_yaw * right,
        sin_yaw * ahead + cos_yaw * right,
        down + GRAVITY,
    );

    let p = inertial.rate[0] - state[9];
    let q = inertial.rate[1] - state[10];
    let r = inertial.rate[2] - state[11];
    let turn = (sin_roll * q + cos_roll * r) / cos_pitch;
    let rates = Vector3::new(p + sin_pitch * turn, cos_roll * q - sin_roll * r, turn);

    let mut next = *state;
    for axis in 0..3 {
        next[axis] += period * state[axis + 3];
        next[axis + 3] += period * acceleration[axis];
        next[axis + 6] += period * rates[axis];
    }
    next
}

/// The state after one period; `covariance` becomes the covariance of its errors.
#[function(derivative(advanced, state))]
fn predicted(
    state: &SVector<f64, 12>,
    inertial: &Inertial,
    period: f64,
    covariance: &mut Symmetric<f64, 12>,
) -> SVector<f64, 12> {
    let sin_cos_state_6 = state[6].sin_cos();
    let slope = -sin_cos_state_6.0;
    let sin_cos_state_7 = state[7].sin_cos();
    let slope_2 = -sin_cos_state_7.0;
    let sin_cos_state_8 = state[8].sin_cos();
    let slope_3 = -sin_cos_state_8.0;
    let lift = sin_cos_state_6.0 * inertial.force[1] + sin_cos_state_6.1 * inertial.force[2];
    let lift_d6 = inertial.force[1] * sin_cos_state_6.1 + inertial.force[2] * slope;
    let ahead = sin_cos_state_7.1 * inertial.force[0] + sin_cos_state_7.0 * lift;
    let ahead_d6 = sin_cos_state_7.0 * lift_d6;
    let ahead_d7 = inertial.force[0] * slope_2 + lift * sin_cos_state_7.1;
    let right = sin_cos_state_6.1 * inertial.force[1] - sin_cos_state_6.0 * inertial.force[2];
    let right_d6 = inertial.force[1] * slope - inertial.force[2] * sin_cos_state_6.1;
    let down = sin_cos_state_7.1 * lift - sin_cos_state_7.0 * inertial.force[0];
    let down_d6 = sin_cos_state_7.1 * lift_d6;
    let down_d7 = lift * slope_2 - inertial.force[0] * sin_cos_state_7.1;
    let acceleration_0 = sin_cos_state_8.1 * ahead - sin_cos_state_8.0 * right;
    let acceleration_0_d6 = sin_cos_state_8.1 * ahead_d6 - sin_cos_state_8.0 * right_d6;
    let acceleration_0_d7 = sin_cos_state_8.1 * ahead_d7;
    let acceleration_0_d8 = ahead * slope_3 - right * sin_cos_state_8.1;
    let acceleration_1 = sin_cos_state_8.0 * ahead + sin_cos_state_8.1 * right;
    let acceleration_1_d6 = sin_cos_state_8.0 * ahead_d6 + sin_cos_state_8.1 * right_d6;
    let acceleration_1_d7 = sin_cos_state_8.0 * ahead_d7;
    let acceleration_1_d8 = ahead * sin_cos_state_8.1 + right * slope_3;
    let acceleration_2 = down + GRAVITY;
    let p = inertial.rate[0] - state[9];
    let q = inertial.rate[1] - state[10];
    let r = inertial.rate[2] - state[11];
    let turn = (sin_cos_state_6.0 * q + sin_cos_state_6.1 * r) / sin_cos_state_7.1;
    let turn_d6 = (q * sin_cos_state_6.1 + r * slope) / sin_cos_state_7.1;
    let turn_d7 = -(turn * slope_2) / sin_cos_state_7.1;
    let turn_d10 = -sin_cos_state_6.0 / sin_cos_state_7.1;
    let turn_d11 = -sin_cos_state_6.1 / sin_cos_state_7.1;
    let rates_0 = p + sin_cos_state_7.0 * turn;
    let rates_0_d6 = sin_cos_state_7.0 * turn_d6;
    let rates_0_d7 = turn * sin_cos_state_7.1 + sin_cos_state_7.0 * turn_d7;
    let rates_0_d10 = sin_cos_state_7.0 * turn_d10;
    let rates_0_d11 = sin_cos_state_7.0 * turn_d11;
    let rates_1 = sin_cos_state_6.1 * q - sin_cos_state_6.0 * r;
    let rates_1_d6 = q * slope - r * sin_cos_state_6.1;
    let rates_1_d10 = -sin_cos_state_6.1;
    let next_0 = state[0] + period * state[3];
    let next_3 = state[3] + period * acceleration_0;
    let next_3_d6 = period * acceleration_0_d6;
    let next_3_d7 = period * acceleration_0_d7;
    let next_3_d8 = period * acceleration_0_d8;
    let next_6 = state[6] + period * rates_0;
    let next_6_d6 = 1.0 + period * rates_0_d6;
    let next_6_d7 = period * rates_0_d7;
    let next_6_d9 = -period;
    let next_6_d10 = period * rates_0_d10;
    let next_6_d11 = period * rates_0_d11;
    let next_1 = state[1] + period * state[4];
    let next_4 = state[4] + period * acceleration_1;
    let next_4_d6 = period * acceleration_1_d6;
    let next_4_d7 = period * acceleration_1_d7;
    let next_4_d8 = period * acceleration_1_d8;
    let next_7 = state[7] + period * rates_1;
    let next_7_d6 = period * rates_1_d6;
    let next_7_d10 = period * rates_1_d10;
    let next_7_d11 = period * sin_cos_state_6.0;
    let next_2 = state[2] + period * state[5];
    let next_5 = state[5] + period * acceleration_2;
    let next_5_d6 = period * down_d6;
    let next_5_d7 = period * down_d7;
    let next_8 = state[8] + period * turn;
    let next_8_d6 = period * turn_d6;
    let next_8_d7 = period * turn_d7;
    let next_8_d10 = period * turn_d10;
    let next_8_d11 = period * turn_d11;
    let next = vector![next_0, next_1, next_2, next_3, next_4, next_5, next_6, next_7, next_8, state[9], state[10], state[11]];
    let row_0_0 = covariance.elements[(0, 0)] + period * covariance.elements[(3, 0)];
    let row_0_1 = covariance.elements[(0, 1)] + period * covariance.elements[(3, 1)];
    let row_0_2 = covariance.elements[(0, 2)] + period * covariance.elements[(3, 2)];
    let row_1_1 = covariance.elements[(1, 1)] + period * covariance.elements[(4, 1)];
    let row_1_2 = covariance.elements[(1, 2)] + period * covariance.elements[(4, 2)];
    let row_2_2 = covariance.elements[(2, 2)] + period * covariance.elements[(5, 2)];
    for k in 3..12 {
        let row_0 = covariance.elements[(0, k)] + period * covariance.elements[(3, k)];
        let row_1 = covariance.elements[(1, k)] + period * covariance.elements[(4, k)];
        let row_2 = covariance.elements[(2, k)] + period * covariance.elements[(5, k)];
        covariance.elements[(0, k)] = row_0;
        covariance.elements[(k, 0)] = row_0;
        covariance.elements[(1, k)] = row_1;
        covariance.elements[(k, 1)] = row_1;
        covariance.elements[(2, k)] = row_2;
        covariance.elements[(k, 2)] = row_2;
    }
    let block_0_0 = row_0_0 + period * covariance.elements[(0, 3)];
    let block_1_0 = row_0_1 + period * covariance.elements[(0, 4)];
    let block_1_1 = row_1_1 + period * covariance.elements[(1, 4)];
    let block_2_0 = row_0_2 + period * covariance.elements[(0, 5)];
    let block_2_1 = row_1_2 + period * covariance.elements[(1, 5)];
    let block_2_2 = row_2_2 + period * covariance.elements[(2, 5)];
    covariance.elements[(0, 0)] = block_0_0;
    covariance.elements[(1, 0)] = block_1_0;
    covariance.elements[(0, 1)] = block_1_0;
    covariance.elements[(1, 1)] = block_1_1;
    covariance.elements[(2, 0)] = block_2_0;
    covariance.elements[(0, 2)] = block_2_0;
    covariance.elements[(2, 1)] = block_2_1;
    covariance.elements[(1, 2)] = block_2_1;
    covariance.elements[(2, 2)] = block_2_2;
    let row_3_3 = covariance.elements[(3, 3)] + next_3_d6 * covariance.elements[(6, 3)] + next_3_d7 * covariance.elements[(7, 3)] + next_3_d8 * covariance.elements[(8, 3)];
    let row_3_4 = covariance.elements[(3, 4)] + next_3_d6 * covariance.elements[(6, 4)] + next_3_d7 * covariance.elements[(7, 4)] + next_3_d8 * covariance.elements[(8, 4)];
    let row_3_5 = covariance.elements[(3, 5)] + next_3_d6 * covariance.elements[(6, 5)] + next_3_d7 * covariance.elements[(7, 5)] + next_3_d8 * covariance.elements[(8, 5)];
    let row_4_4 = covariance.elements[(4, 4)] + next_4_d6 * covariance.elements[(6, 4)] + next_4_d7 * covariance.elements[(7, 4)] + next_4_d8 * covariance.elements[(8, 4)];
    let row_4_5 = covariance.elements[(4, 5)] + next_4_d6 * covariance.elements[(6, 5)] + next_4_d7 * covariance.elements[(7, 5)] + next_4_d8 * covariance.elements[(8, 5)];
    let row_5_5 = covariance.elements[(5, 5)] + next_5_d6 * covariance.elements[(6, 5)] + next_5_d7 * covariance.elements[(7, 5)];
    for k in 0..3 {
        let row_3 = covariance.elements[(3, k)] + next_3_d6 * covariance.elements[(6, k)] + next_3_d7 * covariance.elements[(7, k)] + next_3_d8 * covariance.elements[(8, k)];
        let row_4 = covariance.elements[(4, k)] + next_4_d6 * covariance.elements[(6, k)] + next_4_d7 * covariance.elements[(7, k)] + next_4_d8 * covariance.elements[(8, k)];
        let row_5 = covariance.elements[(5, k)] + next_5_d6 * covariance.elements[(6, k)] + next_5_d7 * covariance.elements[(7, k)];
        covariance.elements[(3, k)] = row_3;
        covariance.elements[(k, 3)] = row_3;
        covariance.elements[(4, k)] = row_4;
        covariance.elements[(k, 4)] = row_4;
        covariance.elements[(5, k)] = row_5;
        covariance.elements[(k, 5)] = row_5;
    }
    for k in 6..12 {
        let row_3 = covariance.elements[(3, k)] + next_3_d6 * covariance.elements[(6, k)] + next_3_d7 * covariance.elements[(7, k)] + next_3_d8 * covariance.elements[(8, k)];
        let row_4 = covariance.elements[(4, k)] + next_4_d6 * covariance.elements[(6, k)] + next_4_d7 * covariance.elements[(7, k)] + next_4_d8 * covariance.elements[(8, k)];
        let row_5 = covariance.elements[(5, k)] + next_5_d6 * covariance.elements[(6, k)] + next_5_d7 * covariance.elements[(7, k)];
        covariance.elements[(3, k)] = row_3;
        covariance.elements[(k, 3)] = row_3;
        covariance.elements[(4, k)] = row_4;
        covariance.elements[(k, 4)] = row_4;
        covariance.elements[(5, k)] = row_5;
        covariance.elements[(k, 5)] = row_5;
    }
    let block_3_3 = row_3_3 + next_3_d6 * covariance.elements[(3, 6)] + next_3_d7 * covariance.elements[(3, 7)] + next_3_d8 * covariance.elements[(3, 8)];
    let block_4_3 = row_3_4 + next_4_d6 * covariance.elements[(3, 6)] + next_4_d7 * covariance.elements[(3, 7)] + next_4_d8 * covariance.elements[(3, 8)];
    let block_4_4 = row_4_4 + next_4_d6 * covariance.elements[(4, 6)] + next_4_d7 * covariance.elements[(4, 7)] + next_4_d8 * covariance.elements[(4, 8)];
    let block_5_3 = row_3_5 + next_5_d6 * covariance.elements[(3, 6)] + next_5_d7 * covariance.elements[(3, 7)];
    let block_5_4 = row_4_5 + next_5_d6 * covariance.elements[(4, 6)] + next_5_d7 * covariance.elements[(4, 7)];
    let block_5_5 = row_5_5 + next_5_d6 * covariance.elements[(5, 6)] + next_5_d7 * covariance.elements[(5, 7)];
    covariance.elements[(3, 3)] = block_3_3;
    covariance.elements[(4, 3)] = block_4_3;
    covariance.elements[(3, 4)] = block_4_3;
    covariance.elements[(4, 4)] = block_4_4;
    covariance.elements[(5, 3)] = block_5_3;
    covariance.elements[(3, 5)] = block_5_3;
    covariance.elements[(5, 4)] = block_5_4;
    covariance.elements[(4, 5)] = block_5_4;
    covariance.elements[(5, 5)] = block_5_5;
    for k in 0..12 {
        let row_6 = next_6_d6 * covariance.elements[(6, k)] + next_6_d7 * covariance.elements[(7, k)] + next_6_d9 * covariance.elements[(9, k)] + next_6_d10 * covariance.elements[(10, k)] + next_6_d11 * covariance.elements[(11, k)];
        let row_7 = covariance.elements[(7, k)] + next_7_d6 * covariance.elements[(6, k)] + next_7_d10 * covariance.elements[(10, k)] + next_7_d11 * covariance.elements[(11, k)];
        let row_8 = covariance.elements[(8, k)] + next_8_d6 * covariance.elements[(6, k)] + next_8_d7 * covariance.elements[(7, k)] + next_8_d10 * covariance.elements[(10, k)] + next_8_d11 * covariance.elements[(11, k)];
        covariance.elements[(6, k)] = row_6;
        covariance.elements[(7, k)] = row_7;
        covariance.elements[(8, k)] = row_8;
        if !(6..9).contains(&k) {
            covariance.elements[(k, 6)] = row_6;
            covariance.elements[(k, 7)] = row_7;
            covariance.elements[(k, 8)] = row_8;
        }
    }
    let block_6_6 = next_6_d6 * covariance.elements[(6, 6)] + next_6_d7 * covariance.elements[(6, 7)] + next_6_d9 * covariance.elements[(6, 9)] + next_6_d10 * covariance.elements[(6, 10)] + next_6_d11 * covariance.elements[(6, 11)];
    let block_7_6 = covariance.elements[(6, 7)] + next_7_d6 * covariance.elements[(6, 6)] + next_7_d10 * covariance.elements[(6, 10)] + next_7_d11 * covariance.elements[(6, 11)];
    let block_7_7 = covariance.elements[(7, 7)] + next_7_d6 * covariance.elements[(7, 6)] + next_7_d10 * covariance.elements[(7, 10)] + next_7_d11 * covariance.elements[(7, 11)];
    let block_8_6 = covariance.elements[(6, 8)] + next_8_d6 * covariance.elements[(6, 6)] + next_8_d7 * covariance.elements[(6, 7)] + next_8_d10 * covariance.elements[(6, 10)] + next_8_d11 * covariance.elements[(6, 11)];
    let block_8_7 = covariance.elements[(7, 8)] + next_8_d6 * covariance.elements[(7, 6)] + next_8_d7 * covariance.elements[(7, 7)] + next_8_d10 * covariance.elements[(7, 10)] + next_8_d11 * covariance.elements[(7, 11)];
    let block_8_8 = covariance.elements[(8, 8)] + next_8_d6 * covariance.elements[(8, 6)] + next_8_d7 * covariance.elements[(8, 7)] + next_8_d10 * covariance.elements[(8, 10)] + next_8_d11 * covariance.elements[(8, 11)];
    covariance.elements[(6, 6)] = block_6_6;
    covariance.elements[(7, 6)] = block_7_6;
    covariance.elements[(6, 7)] = block_7_6;
    covariance.elements[(7, 7)] = block_7_7;
    covariance.elements[(8, 6)] = block_8_6;
    covariance.elements[(6, 8)] = block_8_6;
    covariance.elements[(8, 7)] = block_8_7;
    covariance.elements[(7, 8)] = block_8_7;
    covariance.elements[(8, 8)] = block_8_8;
    next
}

/// The filter.
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct Navigation {
    /// State, in the order of [`advanced`].
    pub state: SVector<f64, 12>,
    /// Covariance of its errors.
    pub covariance: Symmetric<f64, 12>,
}

impl Default for Navigation {
    fn default() -> Self {
        let mut spread = SVector::<f64, 12>::zeros();
        for axis in 0..3 {
            spread[axis] = 1.0;
            spread[axis + 3] = 0.1;
            spread[axis + 6] = 0.01;
            spread[axis + 9] = 1e-4;
        }
        Navigation { state: SVector::zeros(), covariance: Symmetric::diagonal(&spread) }
    }
}

#[component]
impl Navigation {
    /// Predicts one period, s.
    #[entry(infallible)]
    pub fn predict(&mut self, inertial: &Inertial, period: f64) {
        self.state = predicted(&self.state, inertial, period, &mut self.covariance);
        for axis in 0..3 {
            self.covariance.elements[(axis + 3, axis + 3)] += 0.01 * period;
            self.covariance.elements[(axis + 6, axis + 6)] += 1e-5 * period;
            self.covariance.elements[(axis + 9, axis + 9)] += 1e-8 * period;
        }
    }

    /// Corrects by a measured position, m, and velocity, m/s; returns the report.
    #[entry(infallible)]
    pub fn correct(&mut self, measured: &SVector<f64, 6>) -> Correction<f64> {
        let innovation = measured - self.state.fixed_rows::<6>(0);
        let variances = SVector::from([0.25, 0.25, 0.25, 0.01, 0.01, 0.01]);
        self.covariance.correct_part::<0, 6>(&mut self.state, &innovation, &variances, GATE)
    }
}
