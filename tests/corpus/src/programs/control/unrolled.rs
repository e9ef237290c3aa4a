//! `#[unroll(4)]` makes compilers unroll a loop four times; `#[keep]` prevents unrolling.

use bessemer::prelude::*;

/// The sum of the weighted values.
#[function]
pub fn weighted(values: &[f32; 16], weights: &[f32; 16]) -> f32 {
    let mut sum = 0.0;
    #[unroll(4)]
    for i in 0..16 {
        sum += values[i] * weights[i];
    }
    sum
}

/// The scalar product of four elements, as a loop because it is short.
#[function]
pub fn short(values: &[f32; 4], weights: [f32; 4]) -> f32 {
    let mut sum = 0.0;
    #[keep]
    for (value, weight) in values.iter().zip(weights) {
        sum += value * weight;
    }
    sum
}
