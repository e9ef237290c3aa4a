//! Position, velocity and the accelerometer's bias along one axis: a Kalman filter of three states.
//!
//! No sensor is known here; a correction is any measurement that is linear in the state.

use bessemer::prelude::*;
use bessemer_estimation::{Status, Symmetric};

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
    /// Covariance of the errors of these, in this order.
    pub covariance: Symmetric<f64, 3>,
}

#[data]
impl AxisFilter {
    /// Returns a state at rest at 0, with standard deviations `place`, m, and `bias`, m/s².
    pub fn at_rest(place: f64, bias: f64) -> AxisFilter {
        let variances = Vector3::new(place * place, 0.01, bias * bias);
        AxisFilter { state: Vector3::zeros(), covariance: Symmetric::diagonal(&variances) }
    }

    /// Predicts one period, s, from a measured acceleration, m/s², with standard deviation `noise`, m/s², and bias
    /// drift `drift`, m/s² in a second.
    #[requirement("HLR-26")]
    pub fn predict(&mut self, acceleration: f64, period: f64, noise: f64, drift: f64) {
        self.state = predicted(&self.state, acceleration, period, &mut self.covariance);
        let push = noise * period;
        let wander = drift * drift * period;
        let slip = 0.5 * push * period;
        self.covariance.add_diagonal(&Vector3::new(slip * slip, push * push, wander));
    }

    /// Inflates the covariance of position and velocity by (0.5 m)² and (0.5 m/s)², so that the gate accepts larger
    /// innovations.
    pub fn inflate(&mut self) {
        self.covariance.elements[(POSITION, POSITION)] += 0.25;
        self.covariance.elements[(VELOCITY, VELOCITY)] += 0.25;
    }

    /// Corrects the state by a measurement of `row` · state with the passed variance. The measurement is rejected, and
    /// nothing changes, if the innovation exceeds `gate` standard deviations or is not a number.
    #[requirement("HLR-20")]
    pub fn correct(&mut self, row: &Vector3<f64>, measured: f64, variance: f64, gate: f64) -> bool {
        let innovation = measured - row.dot(&self.state);
        let report =
            self.covariance.correct(&mut self.state, row, innovation, variance, gate * gate);
        report.status == Status::Corrected
    }
}

/// Returns the state after one period, s, of a measured acceleration, m/s².
#[function]
#[inline]
fn advanced(state: &Vector3<f64>, acceleration: f64, period: f64) -> Vector3<f64> {
    let real = acceleration - state[BIAS];
    Vector3::new(
        state[POSITION] + period * (state[VELOCITY] + 0.5 * period * real),
        state[VELOCITY] + period * real,
        state[BIAS],
    )
}

/// Returns the state after one period, s. The covariance becomes the covariance of its errors.
#[function(derivative(advanced, state))]
fn predicted(
    state: &Vector3<f64>,
    acceleration: f64,
    period: f64,
    covariance: &mut Symmetric<f64, 3>,
) -> Vector3<f64> {
    let real = acceleration - state[2];
    let result = 0.5 * period;
    let result_0 = state[0] + period * (state[1] + result * real);
    let result_0_d2 = period * -result;
    let result_1 = state[1] + period * real;
    let result_1_d2 = -period;
    let next = vector![result_0, result_1, state[2]];
    let row_0_0 = covariance.elements[(0, 0)]
        + period * covariance.elements[(1, 0)]
        + result_0_d2 * covariance.elements[(2, 0)];
    let row_0_1 = covariance.elements[(0, 1)]
        + period * covariance.elements[(1, 1)]
        + result_0_d2 * covariance.elements[(2, 1)];
    let row_1_1 = covariance.elements[(1, 1)] + result_1_d2 * covariance.elements[(2, 1)];
    let row_0 = covariance.elements[(0, 2)]
        + period * covariance.elements[(1, 2)]
        + result_0_d2 * covariance.elements[(2, 2)];
    let row_1 = covariance.elements[(1, 2)] + result_1_d2 * covariance.elements[(2, 2)];
    covariance.elements[(0, 2)] = row_0;
    covariance.elements[(2, 0)] = row_0;
    covariance.elements[(1, 2)] = row_1;
    covariance.elements[(2, 1)] = row_1;
    let block_0_0 = row_0_0 + period * row_0_1 + result_0_d2 * covariance.elements[(0, 2)];
    let block_1_0 = row_0_1 + result_1_d2 * covariance.elements[(0, 2)];
    let block_1_1 = row_1_1 + result_1_d2 * covariance.elements[(1, 2)];
    covariance.elements[(0, 0)] = block_0_0;
    covariance.elements[(1, 0)] = block_1_0;
    covariance.elements[(0, 1)] = block_1_0;
    covariance.elements[(1, 1)] = block_1_1;
    next
}
