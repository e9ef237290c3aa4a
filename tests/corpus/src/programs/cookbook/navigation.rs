//! An extended Kalman filter of twelve states: position, velocity, attitude and the bias of the gyro.
//!
//! The Jacobian of its prediction is a derivative that the generator writes. `bessemer-estimation` keeps the covariance symmetric,
//! and rejects a measurement that is far from the estimate.

use bessemer::prelude::*;
use bessemer_estimation::{Status, Symmetric};

/// Acceleration of gravity, m/s².
const GRAVITY: f64 = 9.81;

/// Surprise above which a number is rejected: 5 standard deviations.
const GATE: f64 = 25.0;

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

/// The state after one period, and its Jacobian.
#[function(derivative(advanced, state))]
pub fn linearized(
    state: &SVector<f64, 12>,
    inertial: &Inertial,
    period: f64,
) -> (SVector<f64, 12>, SMatrix<f64, 12, 12>) {
    let sin_state_6 = state[6].sin();
    let cos_state_6 = state[6].cos();
    let slope = -sin_state_6;
    let sin_state_7 = state[7].sin();
    let cos_state_7 = state[7].cos();
    let slope_2 = -sin_state_7;
    let sin_state_8 = state[8].sin();
    let cos_state_8 = state[8].cos();
    let slope_3 = -sin_state_8;
    let lift = sin_state_6 * inertial.force[1] + cos_state_6 * inertial.force[2];
    let lift_d6 = inertial.force[1] * cos_state_6 + inertial.force[2] * slope;
    let ahead = cos_state_7 * inertial.force[0] + sin_state_7 * lift;
    let ahead_d6 = sin_state_7 * lift_d6;
    let ahead_d7 = inertial.force[0] * slope_2 + lift * cos_state_7;
    let right = cos_state_6 * inertial.force[1] - sin_state_6 * inertial.force[2];
    let right_d6 = inertial.force[1] * slope - inertial.force[2] * cos_state_6;
    let down = cos_state_7 * lift - sin_state_7 * inertial.force[0];
    let down_d6 = cos_state_7 * lift_d6;
    let down_d7 = lift * slope_2 - inertial.force[0] * cos_state_7;
    let acceleration_0 = cos_state_8 * ahead - sin_state_8 * right;
    let acceleration_0_d6 = cos_state_8 * ahead_d6 - sin_state_8 * right_d6;
    let acceleration_0_d7 = cos_state_8 * ahead_d7;
    let acceleration_0_d8 = ahead * slope_3 - right * cos_state_8;
    let acceleration_1 = sin_state_8 * ahead + cos_state_8 * right;
    let acceleration_1_d6 = sin_state_8 * ahead_d6 + cos_state_8 * right_d6;
    let acceleration_1_d7 = sin_state_8 * ahead_d7;
    let acceleration_1_d8 = ahead * cos_state_8 + right * slope_3;
    let acceleration_2 = down + GRAVITY;
    let p = inertial.rate[0] - state[9];
    let q = inertial.rate[1] - state[10];
    let r = inertial.rate[2] - state[11];
    let turn = (sin_state_6 * q + cos_state_6 * r) / cos_state_7;
    let turn_d6 = (q * cos_state_6 + r * slope) / cos_state_7;
    let turn_d7 = -(turn * slope_2) / cos_state_7;
    let turn_d10 = -sin_state_6 / cos_state_7;
    let turn_d11 = -cos_state_6 / cos_state_7;
    let rates_0 = p + sin_state_7 * turn;
    let rates_0_d6 = sin_state_7 * turn_d6;
    let rates_0_d7 = turn * cos_state_7 + sin_state_7 * turn_d7;
    let rates_0_d10 = sin_state_7 * turn_d10;
    let rates_0_d11 = sin_state_7 * turn_d11;
    let rates_1 = cos_state_6 * q - sin_state_6 * r;
    let rates_1_d6 = q * slope - r * cos_state_6;
    let rates_1_d10 = -cos_state_6;
    let next = state[0] + period * state[3];
    let next_2 = state[3] + period * acceleration_0;
    let next_d6 = period * acceleration_0_d6;
    let next_d7 = period * acceleration_0_d7;
    let next_d8 = period * acceleration_0_d8;
    let next_3 = state[6] + period * rates_0;
    let next_d6_2 = 1.0 + period * rates_0_d6;
    let next_d7_2 = period * rates_0_d7;
    let next_d9 = -period;
    let next_d10 = period * rates_0_d10;
    let next_d11 = period * rates_0_d11;
    let next_4 = state[1] + period * state[4];
    let next_5 = state[4] + period * acceleration_1;
    let next_d6_3 = period * acceleration_1_d6;
    let next_d7_3 = period * acceleration_1_d7;
    let next_d8_2 = period * acceleration_1_d8;
    let next_6 = state[7] + period * rates_1;
    let next_d6_4 = period * rates_1_d6;
    let next_d10_2 = period * rates_1_d10;
    let next_d11_2 = period * sin_state_6;
    let next_7 = state[2] + period * state[5];
    let next_8 = state[5] + period * acceleration_2;
    let next_d6_5 = period * down_d6;
    let next_d7_4 = period * down_d7;
    let next_9 = state[8] + period * turn;
    let next_d6_6 = period * turn_d6;
    let next_d7_5 = period * turn_d7;
    let next_d10_3 = period * turn_d10;
    let next_d11_3 = period * turn_d11;
    let mut jacobian: SMatrix<f64, 12, 12> = SMatrix::zeros();
    jacobian[(0, 0)] = 1.0;
    jacobian[(0, 3)] = period;
    jacobian[(1, 1)] = 1.0;
    jacobian[(1, 4)] = period;
    jacobian[(2, 2)] = 1.0;
    jacobian[(2, 5)] = period;
    jacobian[(3, 3)] = 1.0;
    jacobian[(3, 6)] = next_d6;
    jacobian[(3, 7)] = next_d7;
    jacobian[(3, 8)] = next_d8;
    jacobian[(4, 4)] = 1.0;
    jacobian[(4, 6)] = next_d6_3;
    jacobian[(4, 7)] = next_d7_3;
    jacobian[(4, 8)] = next_d8_2;
    jacobian[(5, 5)] = 1.0;
    jacobian[(5, 6)] = next_d6_5;
    jacobian[(5, 7)] = next_d7_4;
    jacobian[(6, 6)] = next_d6_2;
    jacobian[(6, 7)] = next_d7_2;
    jacobian[(6, 9)] = next_d9;
    jacobian[(6, 10)] = next_d10;
    jacobian[(6, 11)] = next_d11;
    jacobian[(7, 6)] = next_d6_4;
    jacobian[(7, 7)] = 1.0;
    jacobian[(7, 10)] = next_d10_2;
    jacobian[(7, 11)] = next_d11_2;
    jacobian[(8, 6)] = next_d6_6;
    jacobian[(8, 7)] = next_d7_5;
    jacobian[(8, 8)] = 1.0;
    jacobian[(8, 10)] = next_d10_3;
    jacobian[(8, 11)] = next_d11_3;
    jacobian[(9, 9)] = 1.0;
    jacobian[(10, 10)] = 1.0;
    jacobian[(11, 11)] = 1.0;
    (vector![next, next_4, next_7, next_2, next_5, next_8, next_3, next_6, next_9, state[9], state[10], state[11]], jacobian)
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
        let (next, jacobian) = linearized(&self.state, inertial, period);
        self.state = next;
        self.covariance.congruence(&jacobian);
        let mut noise = SVector::<f64, 12>::zeros();
        for axis in 0..3 {
            noise[axis + 3] = 0.01 * period;
            noise[axis + 6] = 1e-5 * period;
            noise[axis + 9] = 1e-8 * period;
        }
        self.covariance.add_diagonal(&noise);
    }

    /// Corrects by a measured position, m, and velocity, m/s; returns the number of rejected numbers.
    #[entry(infallible)]
    pub fn correct(&mut self, position: &Vector3<f64>, velocity: &Vector3<f64>) -> u32 {
        let mut rejected = 0;
        for index in 0..6 {
            let (measured, variance) =
                if index < 3 { (position[index], 0.25) } else { (velocity[index - 3], 0.01) };
            let innovation = measured - self.state[index];
            let report = self
                .covariance
                .correct_element(&mut self.state, index, innovation, variance, GATE);
            if report.status != Status::Corrected {
                rejected += 1;
            }
        }
        rejected
    }
}
