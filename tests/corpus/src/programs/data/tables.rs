//! rustc evaluates each `const`; the C has a constant of the same name.

use bessemer::prelude::*;

/// Distance of the table's entries, V.
const STEP: f32 = 5.0 / 8.0;
/// Fuel for each entry, l.
const FUEL: [f32; 9] = [0.0, 1.5, 3.5, 6.0, 9.0, 12.5, 16.5, 21.0, 26.0];
/// Index of the last entry from which the table can be interpolated.
const LAST: usize = FUEL.len() - 2;

/// Fuel for a voltage, interpolated linearly.
#[function]
pub fn fuel(voltage: f32) -> f32 {
    let place = (voltage / STEP).clamp(0.0, 8.0);
    let at = (place as usize).min(LAST);
    FUEL[at] + (FUEL[at + 1] - FUEL[at]) * (place - at as f32)
}
