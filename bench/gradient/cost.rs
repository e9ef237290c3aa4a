//! The cost of `cargo xtask bench --only gradient`, as a user writes it: a rotor in a plane on its way for fifty periods.
#![no_std]

use bessemer::prelude::*;

/// Number of periods.
const PERIODS: usize = 50;

/// The state after one period, s: position, m, and velocity, m/s, ahead and up; tilt, rad. The inputs are the thrust, m/s², and
/// the rate of the tilt, rad/s.
#[function]
fn advanced(state: &SVector<f64, 5>, thrust: f64, turn: f64, period: f64) -> SVector<f64, 5> {
    let (sin, cos) = state[4].sin_cos();
    let drag = 0.1 * (state[2] * state[2] + state[3] * state[3] + 1.0).sqrt();
    let ahead = thrust * sin - drag * state[2];
    let up = thrust * cos - drag * state[3] - 9.81;
    let rates = vector![state[2], state[3], ahead, up, turn];
    state + rates * period
}

/// Cost of a way to a place 5 m ahead and 2 m up.
#[function]
fn cost(start: &SVector<f64, 5>, inputs: &SMatrix<f64, 2, PERIODS>, period: f64) -> f64 {
    let mut state = *start;
    let mut sum = 0.0;
    for k in 0..PERIODS {
        let (thrust, turn) = (inputs[(0, k)], inputs[(1, k)]);
        state = advanced(&state, thrust, turn, period);
        let (ahead, up) = (state[0] - 5.0, state[1] - 2.0);
        sum += ahead * ahead + up * up + 0.01 * (thrust - 9.81) * (thrust - 9.81);
        sum += 0.1 * (turn * turn + state[2] * state[2] + state[3] * state[3]);
    }
    sum
}

/// The cost with its gradient by the inputs.
#[function(gradient(cost, inputs))]
pub fn slopes(
    start: &SVector<f64, 5>,
    inputs: &SMatrix<f64, 2, PERIODS>,
    period: f64,
) -> (f64, SMatrix<f64, 2, PERIODS>) {
    todo!()
}
