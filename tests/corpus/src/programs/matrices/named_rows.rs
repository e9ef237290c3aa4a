//! Rows and columns with names: constants, or the variants of an enum, as indices. The C has the names, too.

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

/// Moves a state, position, velocity and bias, by a time, s, and returns how it depends on the state before.
#[function]
pub fn moved(state: &mut Vector3<f64>, time: f64) -> Matrix3<f64> {
    state[POSITION] += time * state[VELOCITY];
    state[VELOCITY] -= time * state[BIAS];
    let mut advance = Matrix3::identity();
    advance[(POSITION, VELOCITY)] = time;
    advance[(VELOCITY, BIAS)] = -time;
    advance
}

/// A wheel.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Wheel {
    Left,
    Right,
}

/// Moves load from the left wheel to the right one, and returns the sums of the columns for these two.
#[function]
pub fn shifted(loads: &mut [f64; 2], shares: &Matrix2<f64>, load: f64) -> f64 {
    loads[Wheel::Left as usize] -= load;
    loads[Wheel::Right as usize] += load;
    shares[(0, Wheel::Left as usize)] + shares[(1, Wheel::Right as usize)]
}
