//! An autopilot's filter of 24 states: attitude, velocity, position, biases of the sensors, magnetic fields and wind.
//!
//! The indices of its blocks come from a struct with `derive(State)`, its Jacobians from the generator. Velocity and position are elements of the
//! state; the magnetic field depends on ten of them, so that its correction skips the others.

use bessemer::prelude::*;
use bessemer_estimation::{Selection, Status, Symmetric};

/// Acceleration of gravity, m/s².
const GRAVITY: f64 = 9.80665;

/// Surprise above which a measurement is rejected.
const GATE: f64 = 1e6;

/// State of the filter.
#[data]
#[derive(Clone, Copy, Debug, PartialEq, State)]
pub struct Flight {
    /// Quaternion from the body's frame to north, east, down: w, x, y, z.
    pub attitude: SVector<f64, 4>,
    /// Velocity north, east and down, m/s.
    pub velocity: Vector3<f64>,
    /// Position north, east and down, m.
    pub position: Vector3<f64>,
    /// Bias of the rates, rad/s.
    pub gyro_bias: Vector3<f64>,
    /// Bias of the specific force, m/s².
    pub force_bias: Vector3<f64>,
    /// Magnetic field of the Earth, north, east and down, gauss.
    pub field: Vector3<f64>,
    /// Magnetic field of the body, gauss.
    pub body_field: Vector3<f64>,
    /// Wind north and east, m/s.
    pub wind: Vector2<f64>,
}

/// An inertial measurement.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Imu {
    /// Rate of the body, rad/s.
    pub rate: Vector3<f64>,
    /// Specific force in the body's frame, m/s².
    pub force: Vector3<f64>,
}

/// The state after one period, s.
#[function]
fn advanced(state: &SVector<f64, 24>, imu: &Imu, period: f64) -> SVector<f64, 24> {
    let (w, x, y, z) = (state[0], state[1], state[2], state[3]);
    let mut half = Vector3::zeros();
    let mut force = Vector3::zeros();
    for axis in 0..3 {
        half[axis] = 0.5 * period * (imu.rate[axis] - state[Flight::GYRO_BIAS + axis]);
        force[axis] = period * (imu.force[axis] - state[Flight::FORCE_BIAS + axis]);
    }

    let mut next = *state;
    next[0] = w - x * half[0] - y * half[1] - z * half[2];
    next[1] = x + w * half[0] + y * half[2] - z * half[1];
    next[2] = y + w * half[1] + z * half[0] - x * half[2];
    next[3] = z + w * half[2] + x * half[1] - y * half[0];

    let north = (1.0 - 2.0 * (y * y + z * z)) * force[0]
        + 2.0 * (x * y - w * z) * force[1]
        + 2.0 * (x * z + w * y) * force[2];
    let east = 2.0 * (x * y + w * z) * force[0]
        + (1.0 - 2.0 * (x * x + z * z)) * force[1]
        + 2.0 * (y * z - w * x) * force[2];
    let down = 2.0 * (x * z - w * y) * force[0]
        + 2.0 * (y * z + w * x) * force[1]
        + (1.0 - 2.0 * (x * x + y * y)) * force[2];
    next[Flight::VELOCITY] += north;
    next[Flight::VELOCITY + 1] += east;
    next[Flight::VELOCITY + 2] += down + GRAVITY * period;
    for axis in 0..3 {
        next[Flight::POSITION + axis] += period * state[Flight::VELOCITY + axis];
    }
    next
}

/// The state after one period; `covariance` becomes the covariance of its errors.
#[function(derivative(advanced, state))]
fn predicted(
    state: &SVector<f64, 24>,
    imu: &Imu,
    period: f64,
    covariance: &mut Symmetric<f64, 24>,
) -> SVector<f64, 24> {
    let half = 0.5 * period;
    let half_0 = half * (imu.rate[0] - state[10]);
    let half_0_d10 = -half;
    let force_0 = period * (imu.force[0] - state[13]);
    let force_0_d13 = -period;
    let half_2 = 0.5 * period;
    let half_1 = half_2 * (imu.rate[1] - state[11]);
    let half_1_d11 = -half_2;
    let force_1 = period * (imu.force[1] - state[14]);
    let force_1_d14 = -period;
    let half_3 = 0.5 * period;
    let half_2_2 = half_3 * (imu.rate[2] - state[12]);
    let half_2_d12 = -half_3;
    let force_2 = period * (imu.force[2] - state[15]);
    let force_2_d15 = -period;
    let next_0 = state[0] - state[1] * half_0 - state[2] * half_1 - state[3] * half_2_2;
    let next_0_d1 = -half_0;
    let next_0_d2 = -half_1;
    let next_0_d3 = -half_2_2;
    let next_0_d10 = -(state[1] * half_0_d10);
    let next_0_d11 = -(state[2] * half_1_d11);
    let next_0_d12 = -(state[3] * half_2_d12);
    let next_1 = state[1] + state[0] * half_0 + state[2] * half_2_2 - state[3] * half_1;
    let next_1_d3 = -half_1;
    let next_1_d10 = state[0] * half_0_d10;
    let next_1_d11 = -(state[3] * half_1_d11);
    let next_1_d12 = state[2] * half_2_d12;
    let next_2 = state[2] + state[0] * half_1 + state[3] * half_0 - state[1] * half_2_2;
    let next_2_d1 = -half_2_2;
    let next_2_d10 = state[3] * half_0_d10;
    let next_2_d11 = state[0] * half_1_d11;
    let next_2_d12 = -(state[1] * half_2_d12);
    let next_3 = state[3] + state[0] * half_2_2 + state[1] * half_1 - state[2] * half_0;
    let next_3_d2 = -half_0;
    let next_3_d10 = -(state[2] * half_0_d10);
    let next_3_d11 = state[1] * half_1_d11;
    let next_3_d12 = state[0] * half_2_d12;
    let north = 1.0 - 2.0 * (state[2] * state[2] + state[3] * state[3]);
    let north_2 = 2.0 * (state[1] * state[2] - state[0] * state[3]);
    let north_3 = 2.0 * (state[1] * state[3] + state[0] * state[2]);
    let north_4 = north * force_0 + north_2 * force_1 + north_3 * force_2;
    let north_d0 = force_1 * (2.0 * -state[3]) + force_2 * (2.0 * state[2]);
    let north_d1 = force_1 * (2.0 * state[2]) + force_2 * (2.0 * state[3]);
    let north_d2 = force_0 * -(2.0 * (state[2] + state[2])) + force_1 * (2.0 * state[1]) + force_2 * (2.0 * state[0]);
    let north_d3 = force_0 * -(2.0 * (state[3] + state[3])) + force_1 * (2.0 * -state[0]) + force_2 * (2.0 * state[1]);
    let north_d13 = north * force_0_d13;
    let north_d14 = north_2 * force_1_d14;
    let north_d15 = north_3 * force_2_d15;
    let east = 2.0 * (state[1] * state[2] + state[0] * state[3]);
    let east_2 = 1.0 - 2.0 * (state[1] * state[1] + state[3] * state[3]);
    let east_3 = 2.0 * (state[2] * state[3] - state[0] * state[1]);
    let east_4 = east * force_0 + east_2 * force_1 + east_3 * force_2;
    let east_d0 = force_0 * (2.0 * state[3]) + force_2 * (2.0 * -state[1]);
    let east_d1 = force_0 * (2.0 * state[2]) + force_1 * -(2.0 * (state[1] + state[1])) + force_2 * (2.0 * -state[0]);
    let east_d2 = force_0 * (2.0 * state[1]) + force_2 * (2.0 * state[3]);
    let east_d3 = force_0 * (2.0 * state[0]) + force_1 * -(2.0 * (state[3] + state[3])) + force_2 * (2.0 * state[2]);
    let east_d13 = east * force_0_d13;
    let east_d14 = east_2 * force_1_d14;
    let east_d15 = east_3 * force_2_d15;
    let down = 2.0 * (state[1] * state[3] - state[0] * state[2]);
    let down_2 = 2.0 * (state[2] * state[3] + state[0] * state[1]);
    let down_3 = 1.0 - 2.0 * (state[1] * state[1] + state[2] * state[2]);
    let down_4 = down * force_0 + down_2 * force_1 + down_3 * force_2;
    let down_d0 = force_0 * (2.0 * -state[2]) + force_1 * (2.0 * state[1]);
    let down_d1 = force_0 * (2.0 * state[3]) + force_1 * (2.0 * state[0]) + force_2 * -(2.0 * (state[1] + state[1]));
    let down_d2 = force_0 * (2.0 * -state[0]) + force_1 * (2.0 * state[3]) + force_2 * -(2.0 * (state[2] + state[2]));
    let down_d3 = force_0 * (2.0 * state[1]) + force_1 * (2.0 * state[2]);
    let down_d13 = down * force_0_d13;
    let down_d14 = down_2 * force_1_d14;
    let down_d15 = down_3 * force_2_d15;
    let next_4 = state[4] + north_4;
    let next_5 = state[5] + east_4;
    let next_6 = state[6] + (down_4 + GRAVITY * period);
    let next_7 = state[7] + period * state[4];
    let next_8 = state[8] + period * state[5];
    let next_9 = state[9] + period * state[6];
    let next = vector![next_0, next_1, next_2, next_3, next_4, next_5, next_6, next_7, next_8, next_9, state[10], state[11], state[12], state[13], state[14], state[15], state[16], state[17], state[18], state[19], state[20], state[21], state[22], state[23]];
    let row_7_7 = covariance.elements[(7, 7)] + period * covariance.elements[(4, 7)];
    let row_7_8 = covariance.elements[(7, 8)] + period * covariance.elements[(4, 8)];
    let row_7_9 = covariance.elements[(7, 9)] + period * covariance.elements[(4, 9)];
    let row_8_8 = covariance.elements[(8, 8)] + period * covariance.elements[(5, 8)];
    let row_8_9 = covariance.elements[(8, 9)] + period * covariance.elements[(5, 9)];
    let row_9_9 = covariance.elements[(9, 9)] + period * covariance.elements[(6, 9)];
    for k in 0..7 {
        let row_7 = covariance.elements[(7, k)] + period * covariance.elements[(4, k)];
        let row_8 = covariance.elements[(8, k)] + period * covariance.elements[(5, k)];
        let row_9 = covariance.elements[(9, k)] + period * covariance.elements[(6, k)];
        covariance.elements[(7, k)] = row_7;
        covariance.elements[(k, 7)] = row_7;
        covariance.elements[(8, k)] = row_8;
        covariance.elements[(k, 8)] = row_8;
        covariance.elements[(9, k)] = row_9;
        covariance.elements[(k, 9)] = row_9;
    }
    for k in 10..24 {
        let row_7 = covariance.elements[(7, k)] + period * covariance.elements[(4, k)];
        let row_8 = covariance.elements[(8, k)] + period * covariance.elements[(5, k)];
        let row_9 = covariance.elements[(9, k)] + period * covariance.elements[(6, k)];
        covariance.elements[(7, k)] = row_7;
        covariance.elements[(k, 7)] = row_7;
        covariance.elements[(8, k)] = row_8;
        covariance.elements[(k, 8)] = row_8;
        covariance.elements[(9, k)] = row_9;
        covariance.elements[(k, 9)] = row_9;
    }
    let block_7_7 = row_7_7 + period * covariance.elements[(7, 4)];
    let block_8_7 = row_7_8 + period * covariance.elements[(7, 5)];
    let block_8_8 = row_8_8 + period * covariance.elements[(8, 5)];
    let block_9_7 = row_7_9 + period * covariance.elements[(7, 6)];
    let block_9_8 = row_8_9 + period * covariance.elements[(8, 6)];
    let block_9_9 = row_9_9 + period * covariance.elements[(9, 6)];
    covariance.elements[(7, 7)] = block_7_7;
    covariance.elements[(8, 7)] = block_8_7;
    covariance.elements[(7, 8)] = block_8_7;
    covariance.elements[(8, 8)] = block_8_8;
    covariance.elements[(9, 7)] = block_9_7;
    covariance.elements[(7, 9)] = block_9_7;
    covariance.elements[(9, 8)] = block_9_8;
    covariance.elements[(8, 9)] = block_9_8;
    covariance.elements[(9, 9)] = block_9_9;
    let row_4_4 = covariance.elements[(4, 4)] + north_d0 * covariance.elements[(0, 4)] + north_d1 * covariance.elements[(1, 4)] + north_d2 * covariance.elements[(2, 4)] + north_d3 * covariance.elements[(3, 4)] + north_d13 * covariance.elements[(13, 4)] + north_d14 * covariance.elements[(14, 4)] + north_d15 * covariance.elements[(15, 4)];
    let row_4_5 = covariance.elements[(4, 5)] + north_d0 * covariance.elements[(0, 5)] + north_d1 * covariance.elements[(1, 5)] + north_d2 * covariance.elements[(2, 5)] + north_d3 * covariance.elements[(3, 5)] + north_d13 * covariance.elements[(13, 5)] + north_d14 * covariance.elements[(14, 5)] + north_d15 * covariance.elements[(15, 5)];
    let row_4_6 = covariance.elements[(4, 6)] + north_d0 * covariance.elements[(0, 6)] + north_d1 * covariance.elements[(1, 6)] + north_d2 * covariance.elements[(2, 6)] + north_d3 * covariance.elements[(3, 6)] + north_d13 * covariance.elements[(13, 6)] + north_d14 * covariance.elements[(14, 6)] + north_d15 * covariance.elements[(15, 6)];
    let row_5_5 = covariance.elements[(5, 5)] + east_d0 * covariance.elements[(0, 5)] + east_d1 * covariance.elements[(1, 5)] + east_d2 * covariance.elements[(2, 5)] + east_d3 * covariance.elements[(3, 5)] + east_d13 * covariance.elements[(13, 5)] + east_d14 * covariance.elements[(14, 5)] + east_d15 * covariance.elements[(15, 5)];
    let row_5_6 = covariance.elements[(5, 6)] + east_d0 * covariance.elements[(0, 6)] + east_d1 * covariance.elements[(1, 6)] + east_d2 * covariance.elements[(2, 6)] + east_d3 * covariance.elements[(3, 6)] + east_d13 * covariance.elements[(13, 6)] + east_d14 * covariance.elements[(14, 6)] + east_d15 * covariance.elements[(15, 6)];
    let row_6_6 = covariance.elements[(6, 6)] + down_d0 * covariance.elements[(0, 6)] + down_d1 * covariance.elements[(1, 6)] + down_d2 * covariance.elements[(2, 6)] + down_d3 * covariance.elements[(3, 6)] + down_d13 * covariance.elements[(13, 6)] + down_d14 * covariance.elements[(14, 6)] + down_d15 * covariance.elements[(15, 6)];
    for k in 0..4 {
        let row_4 = covariance.elements[(4, k)] + north_d0 * covariance.elements[(0, k)] + north_d1 * covariance.elements[(1, k)] + north_d2 * covariance.elements[(2, k)] + north_d3 * covariance.elements[(3, k)] + north_d13 * covariance.elements[(13, k)] + north_d14 * covariance.elements[(14, k)] + north_d15 * covariance.elements[(15, k)];
        let row_5 = covariance.elements[(5, k)] + east_d0 * covariance.elements[(0, k)] + east_d1 * covariance.elements[(1, k)] + east_d2 * covariance.elements[(2, k)] + east_d3 * covariance.elements[(3, k)] + east_d13 * covariance.elements[(13, k)] + east_d14 * covariance.elements[(14, k)] + east_d15 * covariance.elements[(15, k)];
        let row_6 = covariance.elements[(6, k)] + down_d0 * covariance.elements[(0, k)] + down_d1 * covariance.elements[(1, k)] + down_d2 * covariance.elements[(2, k)] + down_d3 * covariance.elements[(3, k)] + down_d13 * covariance.elements[(13, k)] + down_d14 * covariance.elements[(14, k)] + down_d15 * covariance.elements[(15, k)];
        covariance.elements[(4, k)] = row_4;
        covariance.elements[(k, 4)] = row_4;
        covariance.elements[(5, k)] = row_5;
        covariance.elements[(k, 5)] = row_5;
        covariance.elements[(6, k)] = row_6;
        covariance.elements[(k, 6)] = row_6;
    }
    for k in 7..24 {
        let row_4 = covariance.elements[(4, k)] + north_d0 * covariance.elements[(0, k)] + north_d1 * covariance.elements[(1, k)] + north_d2 * covariance.elements[(2, k)] + north_d3 * covariance.elements[(3, k)] + north_d13 * covariance.elements[(13, k)] + north_d14 * covariance.elements[(14, k)] + north_d15 * covariance.elements[(15, k)];
        let row_5 = covariance.elements[(5, k)] + east_d0 * covariance.elements[(0, k)] + east_d1 * covariance.elements[(1, k)] + east_d2 * covariance.elements[(2, k)] + east_d3 * covariance.elements[(3, k)] + east_d13 * covariance.elements[(13, k)] + east_d14 * covariance.elements[(14, k)] + east_d15 * covariance.elements[(15, k)];
        let row_6 = covariance.elements[(6, k)] + down_d0 * covariance.elements[(0, k)] + down_d1 * covariance.elements[(1, k)] + down_d2 * covariance.elements[(2, k)] + down_d3 * covariance.elements[(3, k)] + down_d13 * covariance.elements[(13, k)] + down_d14 * covariance.elements[(14, k)] + down_d15 * covariance.elements[(15, k)];
        covariance.elements[(4, k)] = row_4;
        covariance.elements[(k, 4)] = row_4;
        covariance.elements[(5, k)] = row_5;
        covariance.elements[(k, 5)] = row_5;
        covariance.elements[(6, k)] = row_6;
        covariance.elements[(k, 6)] = row_6;
    }
    let block_4_4 = row_4_4 + north_d0 * covariance.elements[(4, 0)] + north_d1 * covariance.elements[(4, 1)] + north_d2 * covariance.elements[(4, 2)] + north_d3 * covariance.elements[(4, 3)] + north_d13 * covariance.elements[(4, 13)] + north_d14 * covariance.elements[(4, 14)] + north_d15 * covariance.elements[(4, 15)];
    let block_5_4 = row_4_5 + east_d0 * covariance.elements[(4, 0)] + east_d1 * covariance.elements[(4, 1)] + east_d2 * covariance.elements[(4, 2)] + east_d3 * covariance.elements[(4, 3)] + east_d13 * covariance.elements[(4, 13)] + east_d14 * covariance.elements[(4, 14)] + east_d15 * covariance.elements[(4, 15)];
    let block_5_5 = row_5_5 + east_d0 * covariance.elements[(5, 0)] + east_d1 * covariance.elements[(5, 1)] + east_d2 * covariance.elements[(5, 2)] + east_d3 * covariance.elements[(5, 3)] + east_d13 * covariance.elements[(5, 13)] + east_d14 * covariance.elements[(5, 14)] + east_d15 * covariance.elements[(5, 15)];
    let block_6_4 = row_4_6 + down_d0 * covariance.elements[(4, 0)] + down_d1 * covariance.elements[(4, 1)] + down_d2 * covariance.elements[(4, 2)] + down_d3 * covariance.elements[(4, 3)] + down_d13 * covariance.elements[(4, 13)] + down_d14 * covariance.elements[(4, 14)] + down_d15 * covariance.elements[(4, 15)];
    let block_6_5 = row_5_6 + down_d0 * covariance.elements[(5, 0)] + down_d1 * covariance.elements[(5, 1)] + down_d2 * covariance.elements[(5, 2)] + down_d3 * covariance.elements[(5, 3)] + down_d13 * covariance.elements[(5, 13)] + down_d14 * covariance.elements[(5, 14)] + down_d15 * covariance.elements[(5, 15)];
    let block_6_6 = row_6_6 + down_d0 * covariance.elements[(6, 0)] + down_d1 * covariance.elements[(6, 1)] + down_d2 * covariance.elements[(6, 2)] + down_d3 * covariance.elements[(6, 3)] + down_d13 * covariance.elements[(6, 13)] + down_d14 * covariance.elements[(6, 14)] + down_d15 * covariance.elements[(6, 15)];
    covariance.elements[(4, 4)] = block_4_4;
    covariance.elements[(5, 4)] = block_5_4;
    covariance.elements[(4, 5)] = block_5_4;
    covariance.elements[(5, 5)] = block_5_5;
    covariance.elements[(6, 4)] = block_6_4;
    covariance.elements[(4, 6)] = block_6_4;
    covariance.elements[(6, 5)] = block_6_5;
    covariance.elements[(5, 6)] = block_6_5;
    covariance.elements[(6, 6)] = block_6_6;
    for k in 0..24 {
        let row_0 = covariance.elements[(0, k)] + next_0_d1 * covariance.elements[(1, k)] + next_0_d2 * covariance.elements[(2, k)] + next_0_d3 * covariance.elements[(3, k)] + next_0_d10 * covariance.elements[(10, k)] + next_0_d11 * covariance.elements[(11, k)] + next_0_d12 * covariance.elements[(12, k)];
        let row_1 = covariance.elements[(1, k)] + half_0 * covariance.elements[(0, k)] + half_2_2 * covariance.elements[(2, k)] + next_1_d3 * covariance.elements[(3, k)] + next_1_d10 * covariance.elements[(10, k)] + next_1_d11 * covariance.elements[(11, k)] + next_1_d12 * covariance.elements[(12, k)];
        let row_2 = covariance.elements[(2, k)] + half_1 * covariance.elements[(0, k)] + next_2_d1 * covariance.elements[(1, k)] + half_0 * covariance.elements[(3, k)] + next_2_d10 * covariance.elements[(10, k)] + next_2_d11 * covariance.elements[(11, k)] + next_2_d12 * covariance.elements[(12, k)];
        let row_3 = covariance.elements[(3, k)] + half_2_2 * covariance.elements[(0, k)] + half_1 * covariance.elements[(1, k)] + next_3_d2 * covariance.elements[(2, k)] + next_3_d10 * covariance.elements[(10, k)] + next_3_d11 * covariance.elements[(11, k)] + next_3_d12 * covariance.elements[(12, k)];
        covariance.elements[(0, k)] = row_0;
        covariance.elements[(1, k)] = row_1;
        covariance.elements[(2, k)] = row_2;
        covariance.elements[(3, k)] = row_3;
        if k >= 4 {
            covariance.elements[(k, 0)] = row_0;
            covariance.elements[(k, 1)] = row_1;
            covariance.elements[(k, 2)] = row_2;
            covariance.elements[(k, 3)] = row_3;
        }
    }
    let block_0_0 = covariance.elements[(0, 0)] + next_0_d1 * covariance.elements[(0, 1)] + next_0_d2 * covariance.elements[(0, 2)] + next_0_d3 * covariance.elements[(0, 3)] + next_0_d10 * covariance.elements[(0, 10)] + next_0_d11 * covariance.elements[(0, 11)] + next_0_d12 * covariance.elements[(0, 12)];
    let block_1_0 = covariance.elements[(0, 1)] + half_0 * covariance.elements[(0, 0)] + half_2_2 * covariance.elements[(0, 2)] + next_1_d3 * covariance.elements[(0, 3)] + next_1_d10 * covariance.elements[(0, 10)] + next_1_d11 * covariance.elements[(0, 11)] + next_1_d12 * covariance.elements[(0, 12)];
    let block_1_1 = covariance.elements[(1, 1)] + half_0 * covariance.elements[(1, 0)] + half_2_2 * covariance.elements[(1, 2)] + next_1_d3 * covariance.elements[(1, 3)] + next_1_d10 * covariance.elements[(1, 10)] + next_1_d11 * covariance.elements[(1, 11)] + next_1_d12 * covariance.elements[(1, 12)];
    let block_2_0 = covariance.elements[(0, 2)] + half_1 * covariance.elements[(0, 0)] + next_2_d1 * covariance.elements[(0, 1)] + half_0 * covariance.elements[(0, 3)] + next_2_d10 * covariance.elements[(0, 10)] + next_2_d11 * covariance.elements[(0, 11)] + next_2_d12 * covariance.elements[(0, 12)];
    let block_2_1 = covariance.elements[(1, 2)] + half_1 * covariance.elements[(1, 0)] + next_2_d1 * covariance.elements[(1, 1)] + half_0 * covariance.elements[(1, 3)] + next_2_d10 * covariance.elements[(1, 10)] + next_2_d11 * covariance.elements[(1, 11)] + next_2_d12 * covariance.elements[(1, 12)];
    let block_2_2 = covariance.elements[(2, 2)] + half_1 * covariance.elements[(2, 0)] + next_2_d1 * covariance.elements[(2, 1)] + half_0 * covariance.elements[(2, 3)] + next_2_d10 * covariance.elements[(2, 10)] + next_2_d11 * covariance.elements[(2, 11)] + next_2_d12 * covariance.elements[(2, 12)];
    let block_3_0 = covariance.elements[(0, 3)] + half_2_2 * covariance.elements[(0, 0)] + half_1 * covariance.elements[(0, 1)] + next_3_d2 * covariance.elements[(0, 2)] + next_3_d10 * covariance.elements[(0, 10)] + next_3_d11 * covariance.elements[(0, 11)] + next_3_d12 * covariance.elements[(0, 12)];
    let block_3_1 = covariance.elements[(1, 3)] + half_2_2 * covariance.elements[(1, 0)] + half_1 * covariance.elements[(1, 1)] + next_3_d2 * covariance.elements[(1, 2)] + next_3_d10 * covariance.elements[(1, 10)] + next_3_d11 * covariance.elements[(1, 11)] + next_3_d12 * covariance.elements[(1, 12)];
    let block_3_2 = covariance.elements[(2, 3)] + half_2_2 * covariance.elements[(2, 0)] + half_1 * covariance.elements[(2, 1)] + next_3_d2 * covariance.elements[(2, 2)] + next_3_d10 * covariance.elements[(2, 10)] + next_3_d11 * covariance.elements[(2, 11)] + next_3_d12 * covariance.elements[(2, 12)];
    let block_3_3 = covariance.elements[(3, 3)] + half_2_2 * covariance.elements[(3, 0)] + half_1 * covariance.elements[(3, 1)] + next_3_d2 * covariance.elements[(3, 2)] + next_3_d10 * covariance.elements[(3, 10)] + next_3_d11 * covariance.elements[(3, 11)] + next_3_d12 * covariance.elements[(3, 12)];
    covariance.elements[(0, 0)] = block_0_0;
    covariance.elements[(1, 0)] = block_1_0;
    covariance.elements[(0, 1)] = block_1_0;
    covariance.elements[(1, 1)] = block_1_1;
    covariance.elements[(2, 0)] = block_2_0;
    covariance.elements[(0, 2)] = block_2_0;
    covariance.elements[(2, 1)] = block_2_1;
    covariance.elements[(1, 2)] = block_2_1;
    covariance.elements[(2, 2)] = block_2_2;
    covariance.elements[(3, 0)] = block_3_0;
    covariance.elements[(0, 3)] = block_3_0;
    covariance.elements[(3, 1)] = block_3_1;
    covariance.elements[(1, 3)] = block_3_1;
    covariance.elements[(3, 2)] = block_3_2;
    covariance.elements[(2, 3)] = block_3_2;
    covariance.elements[(3, 3)] = block_3_3;
    next
}

/// Elements of the state on which the measured field depends: attitude, the Earth's field and the body's.
const SEEN: [usize; 10] = [0, 1, 2, 3, 16, 17, 18, 19, 20, 21];

/// The magnetic field that the body measures, gauss, by the elements `SEEN`.
#[function]
fn magnetic(seen: &SVector<f64, 10>) -> Vector3<f64> {
    let (w, x, y, z) = (seen[0], seen[1], seen[2], seen[3]);
    let (north, east, down) = (seen[4], seen[5], seen[6]);
    let ahead = (1.0 - 2.0 * (y * y + z * z)) * north
        + 2.0 * (x * y + w * z) * east
        + 2.0 * (x * z - w * y) * down;
    let right = 2.0 * (x * y - w * z) * north
        + (1.0 - 2.0 * (x * x + z * z)) * east
        + 2.0 * (y * z + w * x) * down;
    let below = 2.0 * (x * z + w * y) * north
        + 2.0 * (y * z - w * x) * east
        + (1.0 - 2.0 * (x * x + y * y)) * down;
    Vector3::new(ahead + seen[7], right + seen[8], below + seen[9])
}

/// The measured field, and its Jacobian.
#[function(derivative(magnetic, seen))]
fn magnetic_jacobian(seen: &SVector<f64, 10>) -> (Vector3<f64>, SMatrix<f64, 3, 10>) {
    let ahead = 1.0 - 2.0 * (seen[2] * seen[2] + seen[3] * seen[3]);
    let ahead_2 = 2.0 * (seen[1] * seen[2] + seen[0] * seen[3]);
    let ahead_3 = 2.0 * (seen[1] * seen[3] - seen[0] * seen[2]);
    let ahead_4 = ahead * seen[4] + ahead_2 * seen[5] + ahead_3 * seen[6];
    let ahead_d0 = seen[5] * (2.0 * seen[3]) + seen[6] * (2.0 * -seen[2]);
    let ahead_d1 = seen[5] * (2.0 * seen[2]) + seen[6] * (2.0 * seen[3]);
    let ahead_d2 = seen[4] * -(2.0 * (seen[2] + seen[2])) + seen[5] * (2.0 * seen[1]) + seen[6] * (2.0 * -seen[0]);
    let ahead_d3 = seen[4] * -(2.0 * (seen[3] + seen[3])) + seen[5] * (2.0 * seen[0]) + seen[6] * (2.0 * seen[1]);
    let right = 2.0 * (seen[1] * seen[2] - seen[0] * seen[3]);
    let right_2 = 1.0 - 2.0 * (seen[1] * seen[1] + seen[3] * seen[3]);
    let right_3 = 2.0 * (seen[2] * seen[3] + seen[0] * seen[1]);
    let right_4 = right * seen[4] + right_2 * seen[5] + right_3 * seen[6];
    let right_d0 = seen[4] * (2.0 * -seen[3]) + seen[6] * (2.0 * seen[1]);
    let right_d1 = seen[4] * (2.0 * seen[2]) + seen[5] * -(2.0 * (seen[1] + seen[1])) + seen[6] * (2.0 * seen[0]);
    let right_d2 = seen[4] * (2.0 * seen[1]) + seen[6] * (2.0 * seen[3]);
    let right_d3 = seen[4] * (2.0 * -seen[0]) + seen[5] * -(2.0 * (seen[3] + seen[3])) + seen[6] * (2.0 * seen[2]);
    let below = 2.0 * (seen[1] * seen[3] + seen[0] * seen[2]);
    let below_2 = 2.0 * (seen[2] * seen[3] - seen[0] * seen[1]);
    let below_3 = 1.0 - 2.0 * (seen[1] * seen[1] + seen[2] * seen[2]);
    let below_4 = below * seen[4] + below_2 * seen[5] + below_3 * seen[6];
    let below_d0 = seen[4] * (2.0 * seen[2]) + seen[5] * (2.0 * -seen[1]);
    let below_d1 = seen[4] * (2.0 * seen[3]) + seen[5] * (2.0 * -seen[0]) + seen[6] * -(2.0 * (seen[1] + seen[1]));
    let below_d2 = seen[4] * (2.0 * seen[0]) + seen[5] * (2.0 * seen[3]) + seen[6] * -(2.0 * (seen[2] + seen[2]));
    let below_d3 = seen[4] * (2.0 * seen[1]) + seen[5] * (2.0 * seen[2]);
    let result_0 = ahead_4 + seen[7];
    let result_1 = right_4 + seen[8];
    let result_2 = below_4 + seen[9];
    let mut jacobian: SMatrix<f64, 3, 10> = SMatrix::zeros();
    jacobian[(0, 0)] = ahead_d0;
    jacobian[(0, 1)] = ahead_d1;
    jacobian[(0, 2)] = ahead_d2;
    jacobian[(0, 3)] = ahead_d3;
    jacobian[(0, 4)] = ahead;
    jacobian[(0, 5)] = ahead_2;
    jacobian[(0, 6)] = ahead_3;
    jacobian[(0, 7)] = 1.0;
    jacobian[(1, 0)] = right_d0;
    jacobian[(1, 1)] = right_d1;
    jacobian[(1, 2)] = right_d2;
    jacobian[(1, 3)] = right_d3;
    jacobian[(1, 4)] = right;
    jacobian[(1, 5)] = right_2;
    jacobian[(1, 6)] = right_3;
    jacobian[(1, 8)] = 1.0;
    jacobian[(2, 0)] = below_d0;
    jacobian[(2, 1)] = below_d1;
    jacobian[(2, 2)] = below_d2;
    jacobian[(2, 3)] = below_d3;
    jacobian[(2, 4)] = below;
    jacobian[(2, 5)] = below_2;
    jacobian[(2, 6)] = below_3;
    jacobian[(2, 9)] = 1.0;
    (vector![result_0, result_1, result_2], jacobian)
}

/// The filter.
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct Autopilot {
    /// State, in the order of [`Flight`].
    pub state: SVector<f64, 24>,
    /// Covariance of its errors.
    pub covariance: Symmetric<f64, 24>,
}

impl Default for Autopilot {
    fn default() -> Self {
        Autopilot { state: SVector::zeros(), covariance: Symmetric::default() }
    }
}

#[component]
impl Autopilot {
    /// Starts with a state and independent errors of these variances.
    #[entry(infallible)]
    pub fn start(&mut self, state: &SVector<f64, 24>, variances: &SVector<f64, 24>) {
        self.state = *state;
        self.covariance = Symmetric::diagonal(variances);
    }

    /// Predicts one period, s.
    #[entry(infallible)]
    pub fn predict(&mut self, imu: &Imu, period: f64) {
        self.state = predicted(&self.state, imu, period, &mut self.covariance);
        let attitude = self.state.fixed_rows::<4>(Flight::ATTITUDE);
        let length = attitude.norm();
        for n in 0..4 {
            self.state[n] /= length;
        }

        for n in 0..4 {
            self.covariance.elements[(n, n)] += 1e-6 * period;
        }
        for axis in 0..3 {
            let velocity = Flight::VELOCITY + axis;
            self.covariance.elements[(velocity, velocity)] += 0.01 * period;
            let gyro = Flight::GYRO_BIAS + axis;
            self.covariance.elements[(gyro, gyro)] += 1e-8 * period;
            let force = Flight::FORCE_BIAS + axis;
            self.covariance.elements[(force, force)] += 1e-6 * period;
            let field = Flight::FIELD + axis;
            self.covariance.elements[(field, field)] += 1e-6 * period;
            let body = Flight::BODY_FIELD + axis;
            self.covariance.elements[(body, body)] += 1e-6 * period;
        }
        for axis in 0..2 {
            let wind = Flight::WIND + axis;
            self.covariance.elements[(wind, wind)] += 0.01 * period;
        }
    }

    /// Corrects by a measured velocity, m/s, and position, m; returns true if they were accepted.
    #[entry(infallible)]
    pub fn place(&mut self, measured: &SVector<f64, 6>) -> bool {
        let innovation = measured - self.state.fixed_rows::<6>(Flight::VELOCITY);
        let variances = SVector::from([0.01, 0.01, 0.01, 0.25, 0.25, 0.25]);
        let report =
            self.covariance.correct_part::<4, 6>(&mut self.state, &innovation, &variances, GATE);
        report.status == Status::Corrected
    }

    /// Corrects by a measured magnetic field, gauss; returns true if it was accepted.
    #[entry(infallible)]
    pub fn compass(&mut self, measured: &Vector3<f64>) -> bool {
        let selection = Selection { indices: SEEN };
        let (expected, jacobian) = magnetic_jacobian(&selection.of(&self.state));
        let innovation = measured - expected;
        let variances = Vector3::new(0.0025, 0.0025, 0.0025);
        let report = self.covariance.correct_selected(
            &mut self.state,
            &selection,
            &jacobian,
            &innovation,
            &variances,
            GATE,
        );
        report.status == Status::Corrected
    }
}
