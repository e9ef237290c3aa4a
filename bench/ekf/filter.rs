//! The filter of `cargo xtask bench --only ekf`, as a user writes it: twelve states, six measured numbers.
#![no_std]

use bessemer::prelude::*;
use bessemer_estimation::{Status, Symmetric};

/// Acceleration of gravity, m/s².
const GRAVITY: f64 = 9.81;

/// Surprise above which a measurement of six numbers is rejected.
const GATE: f64 = 1e6;

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
#[inline]
fn advanced(state: &SVector<f64, 12>, inertial: &Inertial, period: f64) -> SVector<f64, 12> {
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
    todo!()
}

/// The filter.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Navigation {
    /// State, in the order of [`advanced`].
    pub state: SVector<f64, 12>,
    /// Covariance of its errors.
    pub covariance: Symmetric<f64, 12>,
}

#[component]
impl Navigation {
    /// Starts at zero, with independent errors of these variances.
    #[entry(infallible)]
    pub fn start(&mut self, variances: &SVector<f64, 12>) {
        self.state = SVector::zeros();
        self.covariance = Symmetric::diagonal(variances);
    }

    /// Predicts one period, s, and corrects by a measured position, m, and velocity, m/s; returns true if it was accepted.
    #[entry(infallible)]
    pub fn step(&mut self, inertial: &Inertial, period: f64, measured: &SVector<f64, 6>) -> bool {
        self.state = predicted(&self.state, inertial, period, &mut self.covariance);
        for axis in 0..3 {
            self.covariance.elements[(axis + 3, axis + 3)] += 0.01 * period;
            self.covariance.elements[(axis + 6, axis + 6)] += 1e-5 * period;
            self.covariance.elements[(axis + 9, axis + 9)] += 1e-8 * period;
        }

        let innovation = measured - self.state.fixed_rows::<6>(0);
        let variances = SVector::from([0.25, 0.25, 0.25, 0.01, 0.01, 0.01]);
        let report =
            self.covariance.correct_part::<0, 6>(&mut self.state, &innovation, &variances, GATE);
        report.status == Status::Corrected
    }
}
