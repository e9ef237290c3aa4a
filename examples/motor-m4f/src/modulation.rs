//! Space-vector modulation.

use bessemer::prelude::*;

/// Phases of the motor.
pub const PHASES: usize = 3;

/// √3/2.
const HALF_ROOT_3: f32 = 0.866_025_4;

/// Returns the duty cycles of the upper switches for a voltage in the stator plane, V. The common mode is centred, as
/// in space-vector modulation.
#[function]
pub fn duties(alpha: f32, beta: f32, supply: f32) -> [f32; PHASES] {
    let half = 0.5 * alpha;
    let across = HALF_ROOT_3 * beta;
    let phases = [alpha, across - half, -half - across];
    let highest = phases[0].max(phases[1]).max(phases[2]);
    let lowest = phases[0].min(phases[1]).min(phases[2]);
    let middle = 0.5 * (highest + lowest);
    let scale = 1.0 / supply;
    let mut duties = [0.0; PHASES];
    for k in 0..PHASES {
        duties[k] = (0.5 + (phases[k] - middle) * scale).clamp(0.0, 1.0);
    }
    duties
}
