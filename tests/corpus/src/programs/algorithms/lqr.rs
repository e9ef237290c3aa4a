//! State feedback with gains interpolated over the airspeed.

use bessemer::prelude::*;

/// Airspeeds of the table, m/s.
const AIRSPEEDS: [f32; 3] = [12.0, 18.0, 30.0];
/// For each airspeed, the gains of angle of attack, pitch rate and pitch.
const GAINS: [[f32; 3]; 3] = [[1.8, 0.9, 3.1], [1.2, 0.6, 2.4], [0.7, 0.35, 1.6]];

/// Elevator deflection for a state and an airspeed.
#[function]
pub fn elevator(state: &Vector3<f32>, airspeed: f32) -> f32 {
    let upper: usize = if airspeed < AIRSPEEDS[1] { 1 } else { 2 };
    let lower = upper - 1;
    let share = (airspeed - AIRSPEEDS[lower]) / (AIRSPEEDS[upper] - AIRSPEEDS[lower]);
    let share = share.clamp(0.0, 1.0);
    let mut command = 0.0;
    for i in 0..3 {
        let gain = GAINS[lower][i] + (GAINS[upper][i] - GAINS[lower][i]) * share;
        command -= gain * state[i];
    }
    command.clamp(-0.4, 0.4)
}
