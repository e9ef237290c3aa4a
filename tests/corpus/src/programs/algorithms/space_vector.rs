//! Space-vector modulation: duty cycles of three half bridges by the common-mode shift.

use bessemer::prelude::*;

/// Duty cycles for a voltage vector, as shares of the supply.
#[function]
pub fn duty_cycles(v: &Vector2<f32>) -> [f32; 3] {
    const HALF: f32 = 0.866_025_4;
    let phases = [v.x, HALF * v.y - 0.5 * v.x, -HALF * v.y - 0.5 * v.x];
    let mut least = phases[0];
    let mut most = phases[0];
    for phase in &phases {
        least = least.min(*phase);
        most = most.max(*phase);
    }
    let shift = 0.5 - (most + least) / 2.0;
    let mut duties = [0.0; 3];
    for (duty, phase) in duties.iter_mut().zip(&phases) {
        *duty = (phase + shift).clamp(0.0, 1.0);
    }
    duties
}
