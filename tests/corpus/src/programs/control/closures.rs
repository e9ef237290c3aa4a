//! A named closure is inlined at its calls. `map` of an array and `from_fn` fill arrays.

use bessemer::prelude::*;

/// The response of a first-order low-pass at three frequencies.
#[function]
pub fn response(gain: f64, corner: f64, at: [f64; 3]) -> [f64; 3] {
    let low_pass = |frequency: f64| {
        let ratio = frequency / corner;
        gain / (1.0 + ratio * ratio).sqrt()
    };
    at.map(|frequency| low_pass(frequency) * low_pass(2.0 * frequency))
}

/// A ramp from `low` to `high`.
#[function]
pub fn ramp(low: f32, high: f32) -> [f32; 5] {
    let step = (high - low) / 4.0;
    core::array::from_fn(|i| low + step * i as f32)
}
